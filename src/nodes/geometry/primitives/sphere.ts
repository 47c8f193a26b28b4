import { sphere } from '../../../scene/mesh/primitives.ts';
import { axisParam, countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** A sphere around the origin. */
export const sphereNode = definePrimitive({
  id: 'sphere',
  title: 'node.sphere',
  help: 'node.sphere.help',
  name: 'Sphere',
  params: {
    radius: lengthParam('param.radius', 0.5),
    segments: countParam('param.segments', 64, 3, 1024),
    rings: countParam('param.rings', 32, 2, 512),
    axis: axisParam,
  },
  mesh: ({ radius, segments, rings, axis }) => sphere(radius, { segments, rings, axis: axis as 'Y' }),
});
