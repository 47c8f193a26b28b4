import { cross, dot, length, sub, type Vec3 } from '../../math/vec3.ts';
import type { Check, Stratum } from './twin.ts';

/** 1080 lines over 60°: pixels per radian in the middle of the picture. */
const PIXELS_PER_RADIAN = 935;

type Tolerance = Check['tolerance'];
type Numbers = readonly number[];

const vector = (values: Numbers, at: number): Vec3 => [values[at], values[at + 1], values[at + 2]];

/** One bound up to γ = 100, another beyond. */
export const upTo100 =
  (bound: number, beyond: number): Tolerance =>
  ({ gamma }: Stratum) =>
    gamma <= 100 ? bound : beyond;

export const always = (bound: number): Tolerance => upTo100(bound, bound);

/** Angle between two directions [px], well-conditioned at 0 and π; 0 where both are the zero vector. */
function anglePixels(a: Vec3, b: Vec3): number {
  if (length(a) === 0 && length(b) === 0) return 0;
  return Math.atan2(length(cross(a, b)), dot(a, b)) * PIXELS_PER_RADIAN;
}

/** The vec3 at `at` points the same way. */
export const direction = (at: number, tolerance: Tolerance): Check => ({
  name: 'direction [px]',
  error: (gpu, cpu) => anglePixels(vector(gpu, at), vector(cpu, at)),
  tolerance,
});

/** The vec3 at `at` is as long. */
export const distance = (at: number, tolerance: Tolerance): Check => ({
  name: 'distance, relative',
  error: (gpu, cpu) => {
    const expected = length(vector(cpu, at));
    return Math.abs(length(vector(gpu, at)) - expected) / Math.max(expected, 1e-30);
  },
  tolerance,
});

/** The number at `at`, relative to its value on the CPU. */
export const relative = (name: string, at: number, tolerance: Tolerance): Check => ({
  name: `${name}, relative`,
  error: (gpu, cpu) => Math.abs(gpu[at] - cpu[at]) / Math.max(Math.abs(cpu[at]), 1e-30),
  tolerance,
});

/** `count` numbers from `at`, the largest difference. */
export const absolute = (name: string, at: number, count: number, tolerance: Tolerance): Check => ({
  name,
  error: (gpu, cpu) => Math.max(...Array.from({ length: count }, (_, k) => Math.abs(gpu[at + k] - cpu[at + k]))),
  tolerance,
});

/** The vec3 at `at`: length of the difference over a length that the input or the result tells. */
export const within = (
  name: string,
  at: number,
  scale: (cpu: Numbers, input: Numbers) => number,
  tolerance: Tolerance,
): Check => ({
  name,
  error: (gpu, cpu, input) => length(sub(vector(gpu, at), vector(cpu, at))) / scale(cpu, input),
  tolerance,
});

/** The same check, only where the number at `at` on the CPU is not 0. */
export const where = (at: number, check: Check): Check => ({
  ...check,
  error: (gpu, cpu, input) => (cpu[at] === 0 ? 0 : check.error(gpu, cpu, input)),
});
