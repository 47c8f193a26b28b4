import type { Vec3 } from '../../math/vec3.ts';

/** Steps per octahedral axis; their square is exact in f32. */
export const NORMAL_STEPS = 4096;

/** A unit normal on the octahedron as one exact f32 integer. Called for every point of every sample, so it allocates no pairs. */
export const packNormal = (x: number, y: number, z: number): number =>
  step(octahedral(x, y, z)) * NORMAL_STEPS + step(octahedral(y, x, z));

/**
 * A unit vector as a point of the square −1 … 1: on the octahedron |x| + |y| + |z| = 1, with the lower half folded out (Meyer et al. 2010, "On floating-point
 * normal vectors").
 */
export const encodeOctahedral = (x: number, y: number, z: number): readonly [p: number, q: number] => [
  octahedral(x, y, z),
  octahedral(y, x, z),
];

/** The coordinate along one axis; `across` is the other one. */
function octahedral(along: number, across: number, z: number): number {
  const l = Math.abs(along) + Math.abs(across) + Math.abs(z) || 1;
  const place = along / l;
  return z >= 0 ? place : (1 - Math.abs(across / l)) * Math.sign(place || 1);
}

export function decodeOctahedral(p: number, q: number): Vec3 {
  const z = 1 - Math.abs(p) - Math.abs(q);
  const [x, y] = z >= 0 ? [p, q] : [(1 - Math.abs(q)) * Math.sign(p || 1), (1 - Math.abs(p)) * Math.sign(q || 1)];
  const l = Math.hypot(x, y, z);
  return [x / l, y / l, z / l];
}

const step = (v: number): number => Math.round((v * 0.5 + 0.5) * (NORMAL_STEPS - 1));

/**
 * Steps, an even number, per octahedral axis of a normal in the G-buffer. The lowest bits are stored apart: `NORMAL_LOW_STEPS` of them are one step of its
 * first two numbers.
 */
export const GBUFFER_NORMAL_STEPS = 2 ** 15 - 2;
export const NORMAL_LOW_STEPS = 8;
/** Steps of the reflectance that is stored beside the lowest bits. */
export const REFLECTANCE_STEPS = 511;
/** Subtracted from numbers of 12 bits, because halves hold integers exactly up to it. */
export const CODE_OFFSET = 2048;

/** The normal of a G-buffer pixel (surfacePacking.ts). */
export function unpackGBufferNormal(code: ArrayLike<number>): Vec3 {
  const axis = (k: number): number =>
    NORMAL_LOW_STEPS * (code[k] + CODE_OFFSET) + ((code[k + 2] + CODE_OFFSET) % NORMAL_LOW_STEPS);
  return decodeOctahedral((2 * axis(0)) / GBUFFER_NORMAL_STEPS - 1, (2 * axis(1)) / GBUFFER_NORMAL_STEPS - 1);
}
