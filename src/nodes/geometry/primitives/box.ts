import { box } from '../../../scene/mesh/primitives.ts';
import { definePrimitive, lengthParam } from './definePrimitive.ts';

/** A box centered at the origin. */
export const boxNode = definePrimitive({
  id: 'box',
  title: 'node.box',
  help: 'node.box.help',
  name: 'Box',
  params: {
    width: lengthParam('param.sizeX', 1),
    height: lengthParam('param.sizeY', 1),
    depth: lengthParam('param.sizeZ', 1),
  },
  mesh: ({ width, height, depth }) => box([width, height, depth]),
});
