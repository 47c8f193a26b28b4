import { fromPose } from '../../src/math/mat4.ts';
import { IDENTITY } from '../../src/math/quat.ts';
import { computePointStatistics } from '../../src/scene/streaming/pointStatistics.ts';
import { normalsAt, pointsAt } from '../../src/scene/streaming/samplePoints.ts';
import type { StoredFile, StoredNumbers } from '../../src/scene/streaming/storedNumbers.ts';
import type { PointRecipe } from '../../src/scene/streaming/storedPoints.ts';
import type { SampledPointsMotion } from '../../src/scene/types.ts';

/** The same motion with samples and normals streamed from a "file": bytes in memory, or the host's handle for them. */
export function leftInFile(
  motion: SampledPointsMotion,
  handleOf: (bytes: Uint8Array<ArrayBuffer>) => unknown = (bytes) => bytes,
): SampledPointsMotion {
  const vertices = pointsAt(motion, 0).length / 3;
  const samples = Array.from(motion.times, (_, k) => [pointsAt(motion, k), normalsAt(motion, k)!]).flat();
  const bytes = new Float32Array(6 * vertices * motion.times.length);
  samples.forEach((numbers, i) => {
    bytes.set(numbers, 3 * vertices * i);
  });
  const memory = { name: 'cache.bin', handle: new Uint8Array(bytes.buffer) };
  const recipe = recipeOf(motion, vertices, memory);
  const elsewhere = { name: 'cache.bin', handle: handleOf(memory.handle) };
  const { normals, ...rest } = motion;
  const statistics = computePointStatistics(recipe);
  return { ...rest, points: { ...recipeOf(motion, vertices, elsewhere), statistics } };
}

function recipeOf(motion: SampledPointsMotion, vertices: number, file: StoredFile): PointRecipe {
  const stored = (i: number): StoredNumbers => ({ file, at: 12 * vertices * i, count: 3 * vertices, scalar: 'float' });
  const matrix = fromPose({ position: [0, 0, 0], orientation: IDENTITY });
  return {
    samples: Array.from(motion.times, (_, k) => ({ points: { before: stored(2 * k), fraction: 0 }, matrix })),
    pointOfVertex: Uint32Array.from({ length: vertices }, (_, i) => i),
    shading: {
      kind: 'stored',
      normals: Array.from(motion.times, (_, k) => ({ before: stored(2 * k + 1), fraction: 0 })),
    },
  };
}
