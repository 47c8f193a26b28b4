import { cone, cylinder } from '../../../scene/mesh/primitives.ts';
import { axisParam, countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** A closed cylinder or cone, centered at the origin. */
export const cylinderNode = definePrimitive({
  id: 'cylinder',
  title: 'node.cylinder',
  help: 'node.cylinder.help',
  name: 'Cylinder',
  params: {
    radius: lengthParam('param.radius', 0.5),
    height: lengthParam('param.height', 1),
    pointed: { kind: 'boolean', title: 'param.pointed', help: 'param.pointed.help', default: false },
    segments: countParam('param.segments', 64, 3, 1024),
    axis: axisParam,
  },
  mesh: ({ radius, height, pointed, segments, axis }) =>
    (pointed ? cone : cylinder)(radius, height, { segments, axis: axis as 'Y' }),
});
