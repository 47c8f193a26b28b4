import { cross, dot, length, sub, type Vec3 } from '../../math/vec3.ts';
import type { Check, Stratum } from './twin.ts';

/** Pixels per radian in the middle of a picture with 1080 lines over 60°. */
const PIXELS_PER_RADIAN = 935;

type Tolerance = Check['tolerance'];

const vector = (values: readonly number[], at: number): Vec3 => [values[at], values[at + 1], values[at + 2]];

/** One bound for γ ≤ 100, another above. */
export const upTo100 =
  (bound: number, beyond: number): Tolerance =>
  ({ gamma }: Stratum) =>
    gamma <= 100 ? bound : beyond;

export const always = (bound: number): Tolerance => upTo100(bound, bound);

/** Angle between two directions [px], well conditioned at 0 and π; 0 if both are zero vectors. */
function anglePixels(a: Vec3, b: Vec3): number {
  if (length(a) === 0 && length(b) === 0) return 0;
  return Math.atan2(length(cross(a, b)), dot(a, b)) * PIXELS_PER_RADIAN;
}

/** Checks the direction of the vec3 at `at`. */
export const direction = (at: number, tolerance: Tolerance): Check => ({
  name: 'direction [px]',
  error: (gpu, cpu) => anglePixels(vector(gpu, at), vector(cpu, at)),
  tolerance,
});

/** Checks the length of the vec3 at `at`. */
export const distance = (at: number, tolerance: Tolerance): Check => ({
  name: 'distance, relative',
  error: (gpu, cpu) => {
    const expected = length(vector(cpu, at));
    return Math.abs(length(vector(gpu, at)) - expected) / Math.max(expected, 1e-30);
  },
  tolerance,
});

/** Checks the number at `at`, relative to its CPU value. */
export const relative = (name: string, at: number, tolerance: Tolerance): Check => ({
  name: `${name}, relative`,
  error: (gpu, cpu) => Math.abs(gpu[at] - cpu[at]) / Math.max(Math.abs(cpu[at]), 1e-30),
  tolerance,
});

/** Checks the largest absolute difference of `count` numbers from `at` on. */
export const absolute = (name: string, at: number, count: number, tolerance: Tolerance): Check => ({
  name,
  error: (gpu, cpu) => Math.max(...Array.from({ length: count }, (_, k) => Math.abs(gpu[at + k] - cpu[at + k]))),
  tolerance,
});

/** Checks the length of the difference of the vec3 at `at`, divided by `scale`. */
export const within = (
  name: string,
  at: number,
  scale: (cpu: readonly number[], input: readonly number[]) => number,
  tolerance: Tolerance,
): Check => ({
  name,
  error: (gpu, cpu, input) => length(sub(vector(gpu, at), vector(cpu, at))) / scale(cpu, input),
  tolerance,
});

/** Applies a check only to cases in which the CPU's number at `at` is not 0. */
export const where = (at: number, check: Check): Check => ({
  ...check,
  error: (gpu, cpu, input) => (cpu[at] === 0 ? 0 : check.error(gpu, cpu, input)),
});
