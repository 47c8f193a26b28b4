import { cross, dot, normalize, type Vec3 } from '../../../math/vec3.ts';

/** A point of a rectangle, uniform in its solid angle [sr]. */
export interface SphericalSample {
  readonly x: number;
  readonly y: number;
  readonly solidAngle: number;
}

/**
 * Samples the rectangle x0 … x1, y0 … y1 at the height z0 < 0, seen from the origin, by two random numbers p, q in 0 … 1.
 * Source: Ureña, Fajardo, King 2013, "An area-preserving parametrization for spherical rectangles", EGSR.
 */
export function sphericalRect(
  [x0, x1]: readonly [number, number],
  [y0, y1]: readonly [number, number],
  z0: number,
  p: number,
  q: number,
): SphericalSample {
  const corners: readonly Vec3[] = [
    [x0, y0, z0],
    [x1, y0, z0],
    [x1, y1, z0],
    [x0, y1, z0],
  ];
  const sides = corners.map((corner, i) => normalize(cross(corner, corners[(i + 1) % 4])));
  const [g0, g1, g2, g3] = sides.map((side, i) => Math.acos(clamped(-dot(side, sides[(i + 1) % 4]), 1)));
  const [b0, b1] = [sides[0][2], sides[2][2]];
  const k = 2 * Math.PI - g2 - g3;
  const solidAngle = g0 + g1 - k;
  const au = p * solidAngle + k;
  const fu = (Math.cos(au) * b0 - b1) / Math.sin(au);
  const cu = clamped(Math.sign(fu || 1) / Math.hypot(fu, b0), 1);
  const x = Math.min(Math.max(-(cu * z0) / Math.sqrt(1 - cu * cu), x0), x1);
  const d = Math.hypot(x, z0);
  const [h0, h1] = [y0 / Math.hypot(d, y0), y1 / Math.hypot(d, y1)];
  const h = h0 + q * (h1 - h0);
  const y = h * h < 1 ? Math.min(Math.max((h * d) / Math.sqrt(1 - h * h), y0), y1) : y1;
  return { x, y, solidAngle };
}

const clamped = (x: number, limit: number): number => Math.min(Math.max(x, -limit), limit);
