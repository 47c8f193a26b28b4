import { msg } from '../../../messages/message.ts';
import { box } from '../../../scene/mesh/primitives.ts';
import { definePrimitive, lengthParam } from './definePrimitive.ts';

/** A box centered at the origin. */
export const boxNode = definePrimitive({
  id: 'box',
  title: msg`Box`,
  help: msg`A box centred at the origin.`,
  name: 'Box',
  params: {
    width: lengthParam(msg`Width (x)`, 1),
    height: lengthParam(msg`Height (y)`, 1),
    depth: lengthParam(msg`Depth (z)`, 1),
  },
  mesh: ({ width, height, depth }) => box([width, height, depth]),
});
