import { torus } from '../../../scene/mesh/primitives.ts';
import { axisParam, countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** A torus around the axis through the origin. */
export const torusNode = definePrimitive({
  id: 'torus',
  title: 'node.torus',
  help: 'node.torus.help',
  name: 'Torus',
  params: {
    ring: lengthParam('param.ringRadius', 1),
    tube: lengthParam('param.tubeRadius', 0.25),
    segments: countParam('param.segments', 96, 3, 1024),
    rings: countParam('param.tubeSegments', 32, 3, 512),
    axis: axisParam,
  },
  mesh: ({ ring, tube, segments, rings, axis }) => torus(ring, tube, { segments, rings, axis: axis as 'Y' }),
});
