import { sphere } from '../../scene/primitives.ts';
import { axisParam, definePrimitive, metres, pieces } from './primitive.ts';

/** A ball round the origin. */
export const sphereNode = definePrimitive({
  id: 'sphere',
  title: 'node.sphere',
  help: 'node.sphere.help',
  name: 'Sphere',
  params: {
    radius: metres('param.radius', 0.5),
    segments: pieces('param.segments', 64, 3, 1024),
    rings: pieces('param.rings', 32, 2, 512),
    axis: axisParam,
  },
  mesh: ({ radius, segments, rings, axis }) => sphere(radius, { segments, rings, axis: axis as 'Y' }),
});
