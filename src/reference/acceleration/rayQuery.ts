import { addScaled, normalize, type Vec3 } from '../../math/vec3.ts';
import type { Hit, RayFilter, SpacetimeRay } from './ray.ts';

/** The intersection of a ray with a surface in minimal form; `ObjectIntersector.hitAt` computes the rest. */
export interface Crossing {
  readonly s: number;
  /** Index of the triangle's first corner in `mesh.indices`; of a round solid which of its surfaces. */
  readonly corner: number;
  /** Barycentric weights of the second and third corners. */
  readonly v: number;
  readonly w: number;
  readonly front: boolean;
  /** Index of the piece of the object's motion, where that has more than one. */
  readonly piece: number;
}

/** A box at rest in the coordinates x − v t: min x y z, max x y z [m]. */
export interface MovingBox {
  readonly box: readonly number[];
  /** v [m/s] */
  readonly velocity: Vec3;
}

/** Intersects rays with one object. */
export interface ObjectIntersector {
  /** Index in `Scene.objects`. */
  readonly index: number;
  /** Contains all events of the object; undefined if no such box does, or if the object has no triangles. */
  readonly bounds: MovingBox | undefined;
  /** Whether back sides are visible. */
  readonly doubleSided: boolean;
  /** Offers the crossings between `search.begin` and `search.end` to the search; those beyond the nearest taken so far may be omitted. */
  intersect(ray: SpacetimeRay, search: RayQuery): void;
  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit;
}

/** Places that differ by no more than this fraction, some roundings, are the same. */
const SAME_PLACE = 16 * Number.EPSILON;

/** The search for a ray's nearest hit, or for any. */
export class RayQuery implements Crossing {
  readonly ray: SpacetimeRay;
  /** Crossings before this s are ignored. */
  readonly begin: number;
  /** Crossings beyond this s are ignored; it moves to just behind the nearest crossing found, or to −∞ where any will do. */
  end: number;
  /** The nearest crossing; valid once one has been taken. */
  s = 0;
  corner = 0;
  v = 0;
  w = 0;
  front = false;
  piece = 0;
  private intersector: ObjectIntersector | undefined;
  private readonly filter: RayFilter;

  constructor(ray: SpacetimeRay, filter: RayFilter) {
    this.ray = ray;
    this.begin = filter.begin ?? 0;
    this.end = filter.end ?? Number.POSITIVE_INFINITY;
    this.filter = filter;
  }

  /** Takes a crossing if it is the nearest so far, of several at the same place the one that the scene lists last, and the filter accepts it; returns whether it was taken. */
  offer(
    tracer: ObjectIntersector,
    s: number,
    corner: number,
    v: number,
    w: number,
    front: boolean,
    piece: number,
  ): boolean {
    if (!(s >= this.begin && s <= this.end)) return false;
    const isSamePlace = this.intersector !== undefined && s >= this.s * (1 - SAME_PLACE);
    if (isSamePlace && !this.isBehindTaken(tracer, corner)) return false;
    const { visibleSides, accepts, alwaysAccept, any } = this.filter;
    if (visibleSides && !front && !tracer.doubleSided) return false;
    const ask = accepts && !alwaysAccept?.[tracer.index];
    if (ask && !accepts(tracer.hitAt(this.ray, { s, corner, v, w, front, piece }))) return false;
    this.s = isSamePlace ? Math.min(s, this.s) : s;
    this.end = any ? Number.NEGATIVE_INFINITY : Math.min(this.end, this.s * (1 + SAME_PLACE));
    this.intersector = tracer;
    this.corner = corner;
    this.v = v;
    this.w = w;
    this.front = front;
    this.piece = piece;
    return true;
  }

  /** Whether a triangle is listed after that of the crossing taken last. */
  private isBehindTaken({ index }: ObjectIntersector, corner: number): boolean {
    const taken = this.intersector;
    return !taken || index > taken.index || (index === taken.index && corner > this.corner);
  }

  get nearest(): Hit | undefined {
    return this.intersector?.hitAt(this.ray, this);
  }
}

/** The hit of a crossing where the surface has the velocity β [c] and the triangle the rest-frame normal N of any length. */
export function createHit(
  { t, x, dt, dx }: SpacetimeRay,
  object: number,
  { s, corner, v, w, front }: Crossing,
  c: number,
  velocity: Vec3,
  N: Vec3,
): Hit {
  return {
    s,
    object,
    corner,
    v,
    w,
    time: t + (s * dt) / c,
    position: addScaled(x, dx, s),
    velocity,
    normal: normalize(N),
    front,
  };
}

/** The part of [begin, end] in which the ray's time is within [from, to) (world times [s]), with the end itself where time passes along the ray; empty if its first number is the greater one. */
export function clipToTimes(
  { t, dt }: SpacetimeRay,
  from: number,
  to: number,
  c: number,
  begin: number,
  end: number,
): readonly [begin: number, end: number] {
  if (dt === 0) return from <= t && t < to ? [begin, end] : [1, 0];
  const a = ((from - t) * c) / dt;
  const b = ((to - t) * c) / dt;
  return [Math.max(begin, Math.min(a, b)), Math.min(end, Math.max(a, b))];
}
