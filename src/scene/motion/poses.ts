import { type Quat, rotate } from '../../math/quat.ts';
import { add, type Vec3 } from '../../math/vec3.ts';
import { samplesUntil } from '../../physics/worldLines/samples.ts';
import type { Pose } from '../types.ts';

/** Sample i of rigid poses. */
export function samplePose(poses: ArrayLike<number>, i: number): Pose {
  const k = 7 * i;
  const orientation: Quat = [poses[k + 3], poses[k + 4], poses[k + 5], poses[k + 6]];
  return { position: [poses[k], poses[k + 1], poses[k + 2]], orientation };
}

/** x_world = position + orientation · x */
export const applyPose = (pose: Pose, x: Vec3): Vec3 => add(pose.position, rotate(pose.orientation, x));

/** Maps every pose; 7 numbers per sample. */
export function mapPoses(poses: Float64Array, change: (pose: Pose) => Pose): Float64Array {
  const out = new Float64Array(poses.length);
  for (let k = 0; 7 * k < poses.length; k++) {
    const { position, orientation } = change(samplePose(poses, k));
    out.set([...position, ...orientation], 7 * k);
  }
  return out;
}

/** The samples around t and the fraction between them; outside all samples the nearest one, twice. */
export function pieceAt(times: Float64Array, t: number): { before: number; after: number; s: number } {
  const i = samplesUntil(times, t);
  if (i === 0 || i === times.length) return { before: Math.max(0, i - 1), after: Math.max(0, i - 1), s: 0 };
  return { before: i - 1, after: i, s: (t - times[i - 1]) / (times[i] - times[i - 1]) };
}
