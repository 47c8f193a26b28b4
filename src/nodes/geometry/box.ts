import { box } from '../../scene/primitives.ts';
import { definePrimitive, metres } from './primitive.ts';

/** A box with its middle at the origin. */
export const boxNode = definePrimitive({
  id: 'box',
  title: 'node.box',
  help: 'node.box.help',
  name: 'Box',
  params: {
    width: metres('param.sizeX', 1),
    height: metres('param.sizeY', 1),
    depth: metres('param.sizeZ', 1),
  },
  mesh: ({ width, height, depth }) => box([width, height, depth]),
});
