import { fromMatrix, multiply, type Quat } from '../../src/math/quat.ts';
import { cross, normalize, sub, type Vec3 } from '../../src/math/vec3.ts';
import type { SampledMotion, SceneCamera } from '../../src/scene/types.ts';

const UP: Vec3 = [0, 1, 0];

/** Camera axes that look from `eye` to `target` with the world's up (−Z forward). */
export function lookFrom(eye: Vec3, target: Vec3): Quat {
  const back = normalize(sub(eye, target));
  const right = normalize(cross(UP, back));
  const up = cross(back, right);
  return fromMatrix([right[0], up[0], back[0], right[1], up[1], back[1], right[2], up[2], back[2]]);
}

/** Samples of a motion given as functions of time [s]. */
export function sampled(
  from: number,
  to: number,
  rate: number,
  at: (t: number) => { position: Vec3; orientation: Quat },
): SampledMotion {
  const count = Math.round((to - from) * rate) + 1;
  return sampledAt(
    Array.from({ length: count }, (_, k) => from + ((to - from) * k) / (count - 1)),
    at,
  );
}

/** Samples at the given times [s], increasing. */
export function sampledAt(
  moments: readonly number[],
  at: (t: number) => { position: Vec3; orientation: Quat },
): SampledMotion {
  const times = Float64Array.from(moments);
  const poses = new Float64Array(times.length * 7);
  let before: Quat | undefined;
  for (let k = 0; k < times.length; k++) {
    const { position, orientation } = at(times[k]);
    // Of q and −q the one nearer to the previous, so that interpolation takes the short way.
    const q =
      before && multiply([-before[0], -before[1], -before[2], before[3]], orientation)[3] < 0
        ? orientation.map((x) => -x)
        : orientation;
    before = [q[0], q[1], q[2], q[3]];
    poses.set([...position, ...q], 7 * k);
  }
  return { kind: 'sampled', times, poses };
}

/** 0 → 1, at rest at both ends and at constant speed in the middle: the integral of a trapezoid with smooth ramps. `ramp`: their fraction, 0 … 0.5. */
export function smoothRamp(s: number, ramp = 0.3): number {
  const x = Math.max(0, Math.min(1, s));
  const rise = (y: number) => (y * y * y - (y * y * y * y) / 2) * ramp;
  const total = 1 - ramp;
  if (x < ramp) return rise(x / ramp) / total;
  if (x > 1 - ramp) return 1 - rise((1 - x) / ramp) / total;
  return (x - ramp / 2) / total;
}

/** Fraction of a shuttle's path in which it accelerates. */
export const TURN_SHARE = 0.12;

/** 0 → 1 → 0 … with period 2, at constant speed except near the ends, at rest at integer s. */
export function shuttle(s: number, ramp = TURN_SHARE): number {
  const way = s - 2 * Math.floor(s / 2);
  return way <= 1 ? smoothRamp(way, ramp) : 1 - smoothRamp(way - 1, ramp);
}

export interface CameraFlight {
  /** [s] */
  readonly from: number;
  readonly to: number;
  readonly position: (t: number) => Vec3;
  readonly target: (t: number) => Vec3;
  /** [degrees] */
  readonly fovY?: number;
}

/** The scene's camera: /World/Camera. */
export function camera({ from, to, position: eye, target, fovY = 55 }: CameraFlight): SceneCamera {
  const motion = sampled(from, to, 24, (t) => ({ position: eye(t), orientation: lookFrom(eye(t), target(t)) }));
  return { path: '/World/Camera', motion, fovY: (fovY * Math.PI) / 180 };
}
