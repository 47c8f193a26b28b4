import { conjugate, multiply, rotationAngle, slerp, toMatrix } from '../../math/quat.ts';
import { distance, lerp } from '../../math/vec3.ts';
import type { Pose, SampledMotion } from '../types.ts';
import { samplePose } from './poses.ts';

/** Rigid poses at increasing times: a `SampledMotion` under construction. */
export type PoseSamples = Pick<SampledMotion, 'times' | 'poses'>;

/**
 * Adds samples between those given, so that a point at `radius` [m] from the frame's origin that moves straight from sample
 * to sample stays within `tolerance` [m] of the turning body: with n steps for a turn by θ the chord is at most
 * r(1 − cos(θ/2n)) from the arc. Between given samples the body turns uniformly through the smaller angle.
 */
export function resampleRotation(
  times: ArrayLike<number>,
  poses: ArrayLike<number>,
  radius: number,
  tolerance: number,
): PoseSamples {
  const out = new SampleList();
  const last = times.length - 1;
  const step = 2 * Math.acos(Math.max(-1, 1 - tolerance / Math.max(radius, tolerance)));
  for (let i = 0; i < last; i++) {
    const [a, b] = [samplePose(poses, i), samplePose(poses, i + 1)];
    const angle = rotationAngle(multiply(conjugate(a.orientation), b.orientation));
    const pieces = Math.max(1, Math.ceil(angle / step - 1e-9));
    for (let k = 0; k < pieces; k++) {
      const s = k / pieces;
      const pose =
        s === 0
          ? a
          : { position: lerp(a.position, b.position, s), orientation: slerp(a.orientation, b.orientation, s) };
      out.add(times[i] + s * (times[i + 1] - times[i]), pose);
    }
  }
  if (last >= 0) out.add(times[last], samplePose(poses, last));
  return out.finish();
}

/**
 * Samples any rigid motion t → pose at the given times, and between them until every point within `radius` [m] of
 * the origin stays within `tolerance` [m] of its chord. Each piece is tested at three incommensurable fractions, since a periodic motion can agree at some.
 */
export function sampleMotion(
  at: (t: number) => Pose,
  times: ArrayLike<number>,
  radius: number,
  tolerance: number,
): PoseSamples {
  const out = new SampleList();
  const refine = (t0: number, a: Pose, t1: number, b: Pose, depth: number): void => {
    const deviates = PROBE_FRACTIONS.some((s) => deviation(at(t0 + s * (t1 - t0)), a, b, s, radius) > tolerance);
    if (deviates && depth > 0) {
      const middle = (t0 + t1) / 2;
      const pose = at(middle);
      refine(t0, a, middle, pose, depth - 1);
      refine(middle, pose, t1, b, depth - 1);
    } else out.add(t1, b);
  };
  if (times.length > 0) out.add(times[0], at(times[0]));
  for (let i = 0; i + 1 < times.length; i++)
    refine(times[i], at(times[i]), times[i + 1], at(times[i + 1]), MAX_HALVINGS);
  return out.finish();
}

const PROBE_FRACTIONS = [0.5, 0.2360679774997897, Math.SQRT1_2];
/** At most 2¹² pieces of one given interval: enough for a hundred turns at a tolerance of a thousandth of the radius. */
const MAX_HALVINGS = 12;

/**
 * Upper bound of the distance of a point within `radius` from its chord between two poses: the distance of the positions, plus radius times
 * the Frobenius norm of the difference of the rotations.
 */
function deviation(pose: Pose, a: Pose, b: Pose, s: number, radius: number): number {
  const [r, ra, rb] = [toMatrix(pose.orientation), toMatrix(a.orientation), toMatrix(b.orientation)];
  let sum = 0;
  for (let k = 0; k < 9; k++) sum += (r[k] - (1 - s) * ra[k] - s * rb[k]) ** 2;
  return distance(pose.position, lerp(a.position, b.position, s)) + radius * Math.sqrt(sum);
}

class SampleList {
  private readonly times: number[] = [];
  private readonly poses: number[] = [];

  add(t: number, { position, orientation }: Pose): void {
    this.times.push(t);
    this.poses.push(...position, ...orientation);
  }

  finish(): PoseSamples {
    return { times: Float64Array.from(this.times), poses: Float64Array.from(this.poses) };
  }
}
