/** Steps per octahedral axis; their square is exact in f32. */
export const NORMAL_STEPS = 4096;

/** A unit normal on the octahedron |x| + |y| + |z| = 1, the lower half folded out (Meyer et al. 2010), as one exact f32 integer. */
export function packNormal(x: number, y: number, z: number): number {
  const l = Math.abs(x) + Math.abs(y) + Math.abs(z) || 1;
  const a = x / l;
  const b = y / l;
  const p = z >= 0 ? a : (1 - Math.abs(b)) * Math.sign(a || 1);
  const q = z >= 0 ? b : (1 - Math.abs(a)) * Math.sign(b || 1);
  return step(p) * NORMAL_STEPS + step(q);
}

const step = (v: number): number => Math.round((v * 0.5 + 0.5) * (NORMAL_STEPS - 1));
