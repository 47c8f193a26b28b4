import { msg } from '../../../messages/message.ts';
import { sphere } from '../../../scene/mesh/primitives.ts';
import { axisParam, countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** A sphere around the origin. */
export const sphereNode = definePrimitive({
  id: 'sphere',
  title: msg`Sphere`,
  help: msg`A sphere around the origin.`,
  name: 'Sphere',
  params: {
    radius: lengthParam(msg`Radius`, 0.5),
    segments: countParam(msg`Segments`, 64, 3, 1024),
    rings: countParam(msg`Rings`, 32, 2, 512),
    axis: axisParam,
  },
  mesh: ({ radius, segments, rings, axis }) => sphere(radius, { segments, rings, axis: axis as 'Y' }),
});
