import { addScaled, normalize, type Vec3 } from '../../math/vec3.ts';
import type { Lifetime } from '../../scene/types.ts';
import type { Hit, RayFilter, SpacetimeRay } from './ray.ts';

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

/** A box that stands still in the coordinates x − v t: least x y z, greatest x y z [m]. */
export interface MovingBox {
  readonly box: readonly number[];
  /** v [m/s] */
  readonly velocity: Vec3;
}

/** Finds where rays meet one object. */
export interface ObjectIntersector {
  /** Place in `Scene.objects`. */
  readonly index: number;
  /** Holds all events of the object; undefined where no such box does, and where it has no triangles. */
  readonly bounds: MovingBox | undefined;
  /** Back sides can be seen. */
  readonly doubleSided: boolean;
  /** Offers the crossings between `search.begin` and `search.end` to the search; those behind the nearest that was taken may be left out. */
  intersect(ray: SpacetimeRay, search: RayQuery): void;
  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit;
}

/** What one ray is looking for, and the nearest that it has found. */
export class RayQuery implements Crossing {
  readonly ray: SpacetimeRay;
  /** s from which crossings count. */
  readonly begin: number;
  /** s beyond which nothing counts; the nearest crossing's, once there is one. */
  end: number;
  /** The nearest crossing, where there is one. */
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

  /** Takes a crossing where it is nearer than all before and the ray does not pass through; says whether it was taken. */
  offer(
    tracer: ObjectIntersector,
    s: number,
    corner: number,
    v: number,
    w: number,
    front: boolean,
    piece: number,
  ): boolean {
    if (!(s >= this.begin && s <= this.end) || (s === this.end && this.intersector)) return false;
    const { visibleSides: shown, accepts, alwaysAccept } = this.filter;
    if (shown && !front && !tracer.doubleSided) return false;
    const ask = accepts && !alwaysAccept?.[tracer.index];
    if (ask && !accepts(tracer.hitAt(this.ray, { s, corner, v, w, front, piece }))) return false;
    this.end = s;
    this.intersector = tracer;
    this.s = s;
    this.corner = corner;
    this.v = v;
    this.w = w;
    this.front = front;
    this.piece = piece;
    return true;
  }

  get nearest(): Hit | undefined {
    return this.intersector?.hitAt(this.ray, this);
  }
}

/** A hit where the world line of the surface's point has velocity β [c] and the triangle, in its rest frame, the normal N of any length. */
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

export const isUnlimited = ({ birth, death }: Lifetime): boolean =>
  birth === Number.NEGATIVE_INFINITY && death === Number.POSITIVE_INFINITY;

/** The part of [begin, end] in which the ray's time is within [from, to] (world times [s]); empty where its first number is greater. */
export function clipToTimes(
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
