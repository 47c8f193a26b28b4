import { msg } from '../../../messages/message.ts';
import { torus } from '../../../scene/mesh/primitives.ts';
import { axisParam, countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** A torus around the axis through the origin. */
export const torusNode = definePrimitive({
  id: 'torus',
  title: msg`Torus`,
  help: msg`A torus around an axis through the origin.`,
  name: 'Torus',
  params: {
    ring: lengthParam(msg`Ring radius`, 1),
    tube: lengthParam(msg`Tube radius`, 0.25),
    segments: countParam(msg`Segments`, 96, 3, 1024),
    rings: countParam(msg`Tube segments`, 32, 3, 512),
    axis: axisParam,
  },
  mesh: ({ ring, tube, segments, rings, axis }) => torus(ring, tube, { segments, rings, axis: axis as 'Y' }),
});
