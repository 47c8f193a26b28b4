import { fromPose } from '../../src/math/mat4.ts';
import { IDENTITY } from '../../src/math/quat.ts';
import { surveyPoints } from '../../src/scene/pointFacts.ts';
import { normalsAt, pointsAt } from '../../src/scene/points.ts';
import type { StoredNumbers } from '../../src/scene/storedNumbers.ts';
import type { PointRecipe } from '../../src/scene/streamedPoints.ts';
import type { SampledPointsMotion } from '../../src/scene/types.ts';

/** The same motion with its samples and their normals left in a "file" in memory. */
export function leftInFile(motion: SampledPointsMotion): SampledPointsMotion {
  const vertices = pointsAt(motion, 0).length / 3;
  const samples = Array.from(motion.times, (_, k) => [pointsAt(motion, k), normalsAt(motion, k)!]).flat();
  const bytes = new Float32Array(6 * vertices * motion.times.length);
  samples.forEach((numbers, i) => {
    bytes.set(numbers, 3 * vertices * i);
  });
  const file = { name: 'cache.bin', handle: new Uint8Array(bytes.buffer) };
  const stored = (i: number): StoredNumbers => ({ file, at: 12 * vertices * i, count: 3 * vertices, scalar: 'float' });
  const matrix = fromPose({ position: [0, 0, 0], orientation: IDENTITY });
  const recipe: PointRecipe = {
    samples: Array.from(motion.times, (_, k) => ({ points: { before: stored(2 * k), share: 0 }, matrix })),
    pointOfVertex: Uint32Array.from({ length: vertices }, (_, i) => i),
    shading: {
      kind: 'stored',
      normals: Array.from(motion.times, (_, k) => ({ before: stored(2 * k + 1), share: 0 })),
    },
  };
  const { normals, ...rest } = motion;
  return { ...rest, points: { ...recipe, facts: surveyPoints(recipe) } };
}
