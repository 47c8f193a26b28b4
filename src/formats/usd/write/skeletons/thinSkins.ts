import { type Message, msg } from '../../../../messages/message.ts';
import { pointSamples } from '../../../../scene/motion/motion.ts';
import { isBlended } from '../../../../scene/streaming/samplePoints.ts';
import type { Motion, SceneObject } from '../../../../scene/types.ts';
import { formatBytes } from '../../../diagnostics/inputError.ts';

/** Most bytes of points and normals that skins become. */
const MAX_WRITTEN = 2 ** 30;
const BYTES_PER_VERTEX = 24;

/**
 * Objects with so many samples of their skins that they can be written as points of all vertices, and what that loses. All skins lose the same part of their
 * samples; the first and the last are kept. `keepsJoints`: objects that need no points. `most`: bytes of points and normals.
 */
export function thinSkins(
  objects: readonly SceneObject[],
  keepsJoints: (object: SceneObject) => boolean,
  most = MAX_WRITTEN,
): { readonly objects: readonly SceneObject[]; readonly lost?: Message } {
  const total = objects.reduce((sum, object) => sum + (keepsJoints(object) ? 0 : bytesOf(object)), 0);
  if (total <= most) return { objects };
  const part = most / total;
  const percent = Math.max(1, Math.floor(100 * part));
  return {
    objects: objects.map((object) =>
      keepsJoints(object) ? object : { ...object, motion: thinned(object.motion, part) },
    ),
    lost: msg`the points of its skins at all their times would take ${formatBytes(total)}; they are written at ${percent} % of these times`,
  };
}

function bytesOf({ mesh, motion }: SceneObject): number {
  const samples = pointSamples(motion);
  if (!samples || !isBlended(samples.points)) return 0;
  return (BYTES_PER_VERTEX * samples.times.length * mesh.positions.length) / 3;
}

function thinned(motion: Motion, part: number): Motion {
  const samples = pointSamples(motion);
  if (!samples || !isBlended(samples.points)) return motion;
  const { times, points } = samples;
  const count = Math.max(2, Math.floor(part * times.length));
  const kept = Array.from({ length: count }, (_, i) => Math.round((i * (times.length - 1)) / (count - 1)));
  return {
    ...samples,
    times: Float64Array.from(kept, (k) => times[k]),
    points: {
      ...points,
      nodes: Uint32Array.from(kept, (k) => points.nodes[k]),
      ...(points.shifts && {
        shifts: Float64Array.from(kept.flatMap((k) => [...points.shifts!.subarray(3 * k, 3 * k + 3)])),
      }),
    },
  };
}
