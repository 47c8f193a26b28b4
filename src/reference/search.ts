import { addScaled } from '../math/vec3.ts';
import type { Hit, RayFilter, SpacetimeRay } from './types.ts';

/** Where a ray crosses a triangle, in as few numbers as tell it. */
export interface Crossing {
  readonly s: number;
  /** Place of the triangle's first corner in `mesh.indices`. */
  readonly corner: number;
  /** Weights of the second and third corner. */
  readonly v: number;
  readonly w: number;
  readonly front: boolean;
  /** Which stretch of the object's motion it is in, where that has more than one. */
  readonly piece: number;
}

/** Finds where rays meet one object. */
export interface Tracer {
  /** Offers the crossings between `search.begin` and `search.end` to the search; those behind the nearest that was taken may be left out. */
  trace(ray: SpacetimeRay, search: Search): void;
  describe(ray: SpacetimeRay, crossing: Crossing): Hit;
}

/** What one ray is looking for, and the nearest that it has found. */
export class Search {
  readonly ray: SpacetimeRay;
  /** s from which crossings count. */
  readonly begin: number;
  /** s beyond which nothing counts; the nearest crossing's, once there is one. */
  end: number;
  private readonly accepts: RayFilter['accepts'];
  private tracer: Tracer | undefined;
  private crossing: Crossing | undefined;

  constructor(ray: SpacetimeRay, { begin = 0, end = Number.POSITIVE_INFINITY, accepts }: RayFilter) {
    this.ray = ray;
    this.begin = begin;
    this.end = end;
    this.accepts = accepts;
  }

  /** Takes a crossing where it is nearer than all before and the ray does not pass through; says whether it was taken. */
  offer(tracer: Tracer, s: number, corner: number, v: number, w: number, front: boolean, piece: number): boolean {
    if (!(s >= this.begin && s <= this.end) || (s === this.end && this.crossing)) return false;
    const crossing = { s, corner, v, w, front, piece };
    if (this.accepts && !this.accepts(tracer.describe(this.ray, crossing))) return false;
    this.end = s;
    this.tracer = tracer;
    this.crossing = crossing;
    return true;
  }

  get nearest(): Hit | undefined {
    return this.crossing && this.tracer?.describe(this.ray, this.crossing);
  }
}

/** What is known of a hit from the ray alone. c [m/s]. */
export const eventOf = (
  { t, x, dt, dx }: SpacetimeRay,
  object: number,
  { s, corner, v, w, front }: Crossing,
  c: number,
): Omit<Hit, 'velocity' | 'normal'> => ({
  s,
  object,
  corner,
  v,
  w,
  front,
  time: t + (s * dt) / c,
  position: addScaled(x, dx, s),
});

/**
 * The part of [begin, end] in which the ray's time is within [from, to] (world times [s]); empty where its
 * first number is greater.
 */
export function spanBetween(
  { t, dt }: SpacetimeRay,
  from: number,
  to: number,
  c: number,
  begin: number,
  end: number,
): readonly [begin: number, end: number] {
  if (dt === 0) return from <= t && t <= to ? [begin, end] : [1, 0];
  const a = ((from - t) * c) / dt;
  const b = ((to - t) * c) / dt;
  return [Math.max(begin, Math.min(a, b)), Math.min(end, Math.max(a, b))];
}
