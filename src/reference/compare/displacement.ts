import { cross, dot, length, lerp, sub, type Vec3 } from '../../math/vec3.ts';
import type { VisiblePoints } from './channels.ts';

/**
 * How far, in pixels, B shows a point from where A shows it. At the pixel p, A shows the world point X_A(p) of some object.
 * Near p, B shows that object's points X_B(q) at pixels q, and to first order X_B(q + δ) = X_B(q) + J δ with J = (∂X_B/∂x, ∂X_B/∂y).
 * So B shows A's point at q + δ with
 *
 *     J δ = X_A(p) − X_B(q),   displacement = |q + δ − p|,
 *
 * solved by least squares (two unknowns, three equations). At outlines q = p need not show the object, and at creases J mixes two
 * faces; so q runs over p and its eight neighbours, and the best is the q nearest to A's point by δ and the residual
 * |J δ − (X_A − X_B)|/|J|_min [pixels], both in quadrature. docs/physics.md §12.3.
 */
export interface Displacement {
  /** Per pixel [px]; `LOST` or `UNKNOWN` where it has no value. */
  readonly pixels: Float32Array;
  /** Number of pixels with a displacement. */
  readonly measured: number;
  /** Number of pixels of A whose object, or background, B does not show within one pixel. */
  readonly lost: number;
}

export const LOST = Number.POSITIVE_INFINITY;
/** Both show the background, or the object is too narrow in B for derivatives. */
export const UNKNOWN = Number.NaN;

/** `a`: the picture under test, `b`: the true one. */
export function displacement(a: VisiblePoints, b: VisiblePoints, width: number, height: number): Displacement {
  const gradients = gradientsOf(b, width, height);
  const pixels = new Float32Array(width * height);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) pixels[y * width + x] = displacementAt(a, b, gradients, x, y, width, height);
  return {
    pixels,
    measured: pixels.reduce((count, value) => count + Number(Number.isFinite(value)), 0),
    lost: pixels.reduce((count, value) => count + Number(value === LOST), 0),
  };
}

const pointAt = ({ position: [x, y, z] }: VisiblePoints, i: number): Vec3 => [x[i], y[i], z[i]];

function displacementAt(
  a: VisiblePoints,
  b: VisiblePoints,
  gradients: Float64Array,
  x: number,
  y: number,
  width: number,
  height: number,
): number {
  const here = y * width + x;
  const object = a.object[here];
  if (object === 0 && b.object[here] === 0) return UNKNOWN;
  const point = pointAt(a, here);
  let [best, value, found] = [Number.POSITIVE_INFINITY, UNKNOWN, false];
  for (let qy = Math.max(y - 1, 0); qy <= Math.min(y + 1, height - 1); qy++) {
    for (let qx = Math.max(x - 1, 0); qx <= Math.min(x + 1, width - 1); qx++) {
      const q = qy * width + qx;
      if (b.object[q] !== object) continue;
      found = true;
      const solved = solve(gradientAt(gradients, q), sub(point, pointAt(b, q)));
      if (!solved) continue;
      const away = Math.hypot(solved.dx, solved.dy, solved.remainder);
      if (away < best) [best, value] = [away, Math.hypot(qx - x + solved.dx, qy - y + solved.dy)];
    }
  }
  return found ? value : LOST;
}

/** J: change of the world point [m] from a pixel to the next, to the right and down. */
interface Gradient {
  readonly right: Vec3;
  readonly down: Vec3;
}

/** Six numbers per pixel; NaN where B shows nothing, or shows the object in no neighbouring pixel along that axis. */
function gradientsOf(b: VisiblePoints, width: number, height: number): Float64Array {
  const gradients = new Float64Array(6 * width * height);
  for (let i = 0; i < width * height; i++) {
    const [x, y] = [i % width, Math.floor(i / width)];
    gradients.set(derivative(b, i, x > 0 ? i - 1 : i, x + 1 < width ? i + 1 : i), 6 * i);
    gradients.set(derivative(b, i, y > 0 ? i - width : i, y + 1 < height ? i + width : i), 6 * i + 3);
  }
  return gradients;
}

const gradientAt = (g: Float64Array, pixel: number): Gradient => {
  const i = 6 * pixel;
  return { right: [g[i], g[i + 1], g[i + 2]], down: [g[i + 3], g[i + 4], g[i + 5]] };
};

/** One-sided differences whose lengths differ by more than this factor are not of one smooth surface. */
const SMOOTH = 2;
const NONE: Vec3 = [Number.NaN, Number.NaN, Number.NaN];

/**
 * Central difference over the pixels before and after `i`; one-sided at an outline, and, where one side is far longer (the surface
 * there jumps to another part of the same object), the shorter side alone.
 */
function derivative(b: VisiblePoints, i: number, before: number, after: number): Vec3 {
  const here = pointAt(b, i);
  const isSame = (j: number): boolean => b.object[i] !== 0 && j !== i && b.object[j] === b.object[i];
  const back = isSame(before) ? sub(here, pointAt(b, before)) : undefined;
  const forth = isSame(after) ? sub(pointAt(b, after), here) : undefined;
  if (!back || !forth) return back ?? forth ?? NONE;
  const [backLength, forthLength] = [length(back), length(forth)];
  if (backLength > SMOOTH * forthLength) return forth;
  if (forthLength > SMOOTH * backLength) return back;
  return lerp(back, forth, 0.5);
}

/** δ of J δ = r by least squares, and the length of the residual in units of the shorter column of J. */
function solve(
  { right, down }: Gradient,
  r: Vec3,
): { readonly dx: number; readonly dy: number; readonly remainder: number } | undefined {
  // Cramer's rule on the normal equations, whose determinant is (right × down)².
  const normal = cross(right, down);
  const determinant = dot(normal, normal);
  if (!(determinant > 0)) return undefined;
  const dx = dot(cross(r, down), normal) / determinant;
  const dy = dot(cross(right, r), normal) / determinant;
  const distance = Math.abs(dot(r, normal)) / Math.sqrt(determinant);
  return { dx, dy, remainder: distance / Math.min(length(right), length(down)) };
}
