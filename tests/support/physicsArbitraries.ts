import fc from 'fast-check';
import { expect } from 'vitest';
import { addScaled, cross, length, normalize, scale, type Vec3 } from '../../src/math/vec3.ts';

/** The rapidity of γ = 1000. */
export const MAX_RAPIDITY = Math.acosh(1000);

/** Uniformly distributed, ends included. (fc.double is uniform over bit patterns: half of its numbers are below 1e-150.) */
export const uniform = (min: number, max: number): fc.Arbitrary<number> =>
  fc.integer({ min: 0, max: 2 ** 31 - 1 }).map((i) => min + (max - min) * (i / (2 ** 31 - 1)));

/** 0 instead of a tiny, possibly subnormal number, which has too few digits for a component of a unit vector. */
const flushTiny = (x: number) => (Math.abs(x) < 1e-150 ? 0 : x);

/** A unit vector perpendicular to n, rotated about it by phi [rad]. */
export function perpendicular(n: Vec3, phi = 0): Vec3 {
  const e1 = normalize(cross(n, Math.abs(n[0]) < 0.8 * length(n) ? [1, 0, 0] : [0, 1, 0]));
  return addScaled(scale(e1, Math.cos(phi)), cross(normalize(n), e1), Math.sin(phi));
}

/** Unit vectors, uniform on the sphere, and the axes. */
export const direction: fc.Arbitrary<Vec3> = fc.oneof(
  {
    weight: 8,
    arbitrary: fc.tuple(uniform(-1, 1), uniform(0, 2 * Math.PI)).map(([z, phi]): Vec3 => {
      const s = Math.sqrt(1 - z * z);
      return normalize([flushTiny(s * Math.cos(phi)), flushTiny(s * Math.sin(phi)), flushTiny(z)]);
    }),
  },
  { weight: 1, arbitrary: fc.constantFrom<Vec3>([1, 0, 0], [0, -1, 0], [0, 0, 1]) },
);

/** |u| = sinh ζ: at rest, at walking speed, or anything up to γ = 1000. */
export const rapidityUpTo = (max: number): fc.Arbitrary<number> =>
  fc.oneof(
    { weight: 1, arbitrary: fc.constantFrom(0, max) },
    { weight: 6, arbitrary: uniform(0, max) },
    { weight: 2, arbitrary: uniform(-12, -1).map((e) => 10 ** e) },
  );

/** Proper velocities γβ from rest to `maxGamma`. */
export const properVelocityUpTo = (maxGamma: number): fc.Arbitrary<Vec3> =>
  fc.tuple(direction, rapidityUpTo(Math.acosh(maxGamma))).map(([n, zeta]) => scale(n, Math.sinh(zeta)));

export const anyProperVelocity = properVelocityUpTo(1000);

/** 10^min … 10^max, log-uniform. */
export const magnitude = (min: number, max: number): fc.Arbitrary<number> => uniform(min, max).map((e) => 10 ** e);

/** Offsets between a millimetre and 100 km. */
export const offset: fc.Arbitrary<Vec3> = fc.tuple(direction, magnitude(-3, 5)).map(([n, r]) => scale(n, r));

/** A velocity, and an offset that is sometimes nearly parallel or antiparallel to it, where terms of formulas cancel. */
export const velocityAndOffset: fc.Arbitrary<readonly [u: Vec3, dx: Vec3]> = fc
  .tuple(anyProperVelocity, offset, fc.constantFrom(0, 1, -1), magnitude(-6, 0))
  .map(([u, dx, sign, angle]) => {
    const ahead = normalize(u);
    if (sign === 0 || length(ahead) === 0) return [u, dx];
    const side = normalize(cross(ahead, dx));
    const n = addScaled(scale(ahead, sign * Math.cos(angle)), side, Math.sin(angle));
    return [u, scale(n, length(dx))];
  });

/** Expects every number to be within the absolute `tolerance` of the expected one. */
export function expectClose(
  actual: number | readonly number[],
  expected: number | readonly number[],
  tolerance: number,
) {
  const [a, b] = [[actual].flat(), [expected].flat()] as number[][];
  const worst = Math.max(...a.map((x, i) => Math.abs(x - b[i])));
  const say = () => `${a.join(', ')} is ${worst} from ${b.join(', ')}, more than ${tolerance}`;
  expect(a.length, 'as many numbers').toBe(b.length);
  if (!(worst <= tolerance)) expect.fail(say());
}
