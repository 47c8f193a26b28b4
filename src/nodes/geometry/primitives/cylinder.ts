import { msg } from '../../../messages/message.ts';
import { cone, cylinder } from '../../../scene/mesh/primitives.ts';
import { axisParam, countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** A closed cylinder or cone, centered at the origin. */
export const cylinderNode = definePrimitive({
  id: 'cylinder',
  title: msg`Cylinder`,
  help: msg`A closed cylinder or cone, centred at the origin.`,
  name: 'Cylinder',
  params: {
    radius: lengthParam(msg`Radius`, 0.5),
    height: lengthParam(msg`Height`, 1),
    pointed: { kind: 'boolean', title: msg`Cone`, help: msg`A cone instead of a cylinder.`, default: false },
    segments: countParam(msg`Segments`, 64, 3, 1024),
    axis: axisParam,
  },
  mesh: ({ radius, height, pointed, segments, axis }) =>
    (pointed ? cone : cylinder)(radius, height, { segments, axis: axis as 'Y' }),
});
