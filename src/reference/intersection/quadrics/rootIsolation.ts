import { brent } from '../../../math/roots.ts';
import { norm } from '../../../math/vec3.ts';
import type { Crossings } from './crossings.ts';
import type { BoundingSurface, RoundSolid } from './roundSolid.ts';

/** A ray in the axes of a solid, where it is curved. */
export interface CurvedRay {
  /** Point and its derivative with respect to s; written by `evaluate`. */
  readonly y: Float64Array;
  readonly dy: Float64Array;
  /** Upper bounds of |y′| and |y″| within `half` of the last place evaluated; written by `bound`. */
  speed: number;
  bend: number;
  evaluate(s: number): void;
  bound(s: number, half: number): void;
}

/**
 * Adds all roots of a solid's surfaces between `from` and `to`. With g(s) = F(y(s)) and a bound G of |g″| = |2y′ᵀHy′ + ∇F·y″| on an interval of half
 * width w around m, there is no root where |g(m)| > |g′(m)| w + G w²/2, and g is monotonic where |g′(m)| > G w; any other interval is halved. So no root
 * is missed but a pair that is closer than rounding.
 */
export function addCurveRoots(
  { surfaces }: RoundSolid,
  ray: CurvedRay,
  from: number,
  to: number,
  out: Crossings,
): void {
  for (const surface of surfaces) isolate(surface, ray, from, to, out);
}

function isolate(surface: BoundingSurface, ray: CurvedRay, from: number, to: number, out: Crossings): void {
  const middle = from + (to - from) / 2;
  const half = (to - from) / 2;
  ray.evaluate(middle);
  const { y, dy } = ray;
  const { a, b, c, d } = surface;
  const value = a * (y[0] * y[0] + y[1] * y[1]) + (b * y[2] + c) * y[2] + d;
  const slope = 2 * a * (y[0] * dy[0] + y[1] * dy[1]) + (2 * b * y[2] + c) * dy[2];
  const away = norm(y[0], y[1], y[2]);
  ray.bound(middle, half);
  const curvature = Math.max(Math.abs(a), Math.abs(b));
  const gradient = 2 * curvature * (away + ray.speed * half) + Math.abs(c);
  const most = 2 * curvature * ray.speed * ray.speed + (ray.bend > 0 ? gradient * ray.bend : 0);
  if (Math.abs(value) > half * (Math.abs(slope) + (most * half) / 2)) return;
  const g = (s: number): number => valueAt(surface, ray, s);
  const isDivisible = middle > from && middle < to;
  if (Math.abs(slope) > most * half || !isDivisible) {
    if (g(from) < 0 !== g(to) < 0) out.add(brent(g, from, to), surface.part);
    return;
  }
  isolate(surface, ray, from, middle, out);
  isolate(surface, ray, middle, to, out);
}

function valueAt({ a, b, c, d }: BoundingSurface, ray: CurvedRay, s: number): number {
  ray.evaluate(s);
  const [x, y, z] = ray.y;
  return a * (x * x + y * y) + (b * z + c) * z + d;
}
