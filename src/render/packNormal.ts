import type { Vec3 } from '../math/vec3.ts';

/** Steps per octahedral axis; their square is exact in f32. */
export const NORMAL_STEPS = 4096;

/** A unit normal on the octahedron as one exact f32 integer. */
export function packNormal(x: number, y: number, z: number): number {
  const [p, q] = toOctahedron(x, y, z);
  return step(p) * NORMAL_STEPS + step(q);
}

/** A unit vector as a point of the square −1 … 1: on the octahedron |x| + |y| + |z| = 1, the lower half folded out (Meyer et al. 2010). */
export function toOctahedron(x: number, y: number, z: number): readonly [p: number, q: number] {
  const l = Math.abs(x) + Math.abs(y) + Math.abs(z) || 1;
  const [a, b] = [x / l, y / l];
  return z >= 0 ? [a, b] : [(1 - Math.abs(b)) * Math.sign(a || 1), (1 - Math.abs(a)) * Math.sign(b || 1)];
}

export function fromOctahedron(p: number, q: number): Vec3 {
  const z = 1 - Math.abs(p) - Math.abs(q);
  const [x, y] = z >= 0 ? [p, q] : [(1 - Math.abs(q)) * Math.sign(p || 1), (1 - Math.abs(p)) * Math.sign(q || 1)];
  const l = Math.hypot(x, y, z);
  return [x / l, y / l, z / l];
}

const step = (v: number): number => Math.round((v * 0.5 + 0.5) * (NORMAL_STEPS - 1));
