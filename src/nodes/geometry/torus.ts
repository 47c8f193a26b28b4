import { torus } from '../../scene/primitives.ts';
import { axisParam, definePrimitive, metres, pieces } from './primitive.ts';

/** A ring round the axis through the origin. */
export const torusNode = definePrimitive({
  id: 'torus',
  title: 'node.torus',
  help: 'node.torus.help',
  name: 'Torus',
  params: {
    ring: metres('param.ringRadius', 1),
    tube: metres('param.tubeRadius', 0.25),
    segments: pieces('param.segments', 96, 3, 1024),
    rings: pieces('param.tubeSegments', 32, 3, 512),
    axis: axisParam,
  },
  mesh: ({ ring, tube, segments, rings, axis }) => torus(ring, tube, { segments, rings, axis: axis as 'Y' }),
});
