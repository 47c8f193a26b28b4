import { brent } from '../../math/roots.ts';
import { addScaled, dot, length, normalize, scale, sub } from '../../math/vec3.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import type { HyperbolicMotion, SceneObject } from '../../scene/types.ts';
import { BvhTraversal } from '../acceleration/bvhTraversal.ts';
import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import {
  type Crossing,
  clipToTimes,
  createHit,
  type ObjectIntersector,
  type RayQuery,
} from '../acceleration/rayQuery.ts';
import { type TriangleBvh, triangleNormal } from '../acceleration/triangleBvh.ts';
import { BarycentricTest } from './barycentrics.ts';
import { convexBulge, HyperbolicFrame, type ObjectRayCurve } from './hyperbolicFrame.ts';

const traversal = new BvhTraversal();
const corners = new BarycentricTest();

/** Greatest distance of a chord from the ray's curve, as a fraction of the object's size. */
const MAX_CHORD_ERROR = 0.05;

type HyperbolicObject = SceneObject & { readonly motion: HyperbolicMotion };

/** Intersects rays with the triangles of an object in hyperbolic motion. */
export class HyperbolicRayIntersector implements ObjectIntersector {
  readonly bounds = undefined;
  readonly index: number;
  readonly doubleSided: boolean;
  private readonly object: HyperbolicObject;
  private readonly shape: TriangleBvh;
  private readonly c: number;
  private readonly frame: HyperbolicFrame;
  /** [m] */
  private readonly size: number;

  constructor(index: number, object: HyperbolicObject, shape: TriangleBvh, c: number) {
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.shape = shape;
    this.c = c;
    this.size = Math.max(0, ...shape.bvh.bounds.subarray(0, 6).map(Math.abs));
    this.frame = new HyperbolicFrame(object, this.size, c);
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    const { birth, death } = this.object.lifetime;
    const curve = this.frame.curveOf(ray);
    const [begin, end] = clipToTimes(ray, birth, death, this.c, search.begin, search.end);
    const [from, to] = this.frame.extent(curve, begin, end);
    if (from < to) this.divide(curve, from, to, search);
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const plane = triangleNormal(this.object.mesh, crossing.corner);
    const { velocity, normal } = this.frame.surfaceAt(this.frame.curveOf(ray), crossing.s, plane);
    return createHit(ray, this.index, crossing, this.c, velocity, normal);
  }

  /** Halves the curve until chords approximate it, near parts first, and skips parts that miss the object's boxes. */
  private divide(curve: ObjectRayCurve, from: number, to: number, search: RayQuery): void {
    if (from > search.end) return;
    const [a, b] = [this.frame.lag(curve, from), this.frame.lag(curve, to)];
    const bulge = convexBulge(a, b, this.frame.lagRate(curve, from), this.frame.lagRate(curve, to), to - from);
    const middle = from + (to - from) / 2;
    const divisible = middle > from && middle < to;
    if (bulge < MAX_CHORD_ERROR * this.size || !divisible) {
      this.intersectChord(curve, from, to, a, b, bulge, search);
      return;
    }
    if (bulge < Number.POSITIVE_INFINITY) {
      this.startTraversal(curve, from, to, a, b, bulge);
      if (traversal.next(to - from) < 0) return;
    }
    this.divide(curve, from, middle, search);
    this.divide(curve, middle, to, search);
  }

  /** Starts a traversal along the chord for the curve, which deviates from it by up to `bulge` along A. */
  private startTraversal(curve: ObjectRayCurve, from: number, to: number, a: number, b: number, bulge: number): void {
    const { A } = this.frame;
    const { o, d } = curve;
    const begin = addScaled(addScaled(o, d, from), A, -a);
    const rate = to > from ? (b - a) / (to - from) : 0;
    const direction = addScaled(d, A, -rate);
    const noise = this.frame.noise(curve, to, b);
    traversal.start(this.shape.bvh, [...begin, ...direction], 0);
    traversal.thicken(scale(A, bulge), noise);
  }

  private intersectChord(
    curve: ObjectRayCurve,
    from: number,
    to: number,
    a: number,
    b: number,
    bulge: number,
    search: RayQuery,
  ): void {
    this.startTraversal(curve, from, to, a, b, bulge);
    const { bvh, first } = this.shape;
    for (let leaf = traversal.next(search.end - from); leaf >= 0; leaf = traversal.next(search.end - from)) {
      const start = bvh.link[leaf];
      for (let i = start; i < start + bvh.count[leaf]; i++) this.intersectTriangle(curve, from, to, first[i], search);
    }
  }

  /** g(s) = N·(p − y(s)) is convex or concave, hence monotonic between its ends and its extremum: sign changes bracket the roots. */
  private intersectTriangle(curve: ObjectRayCurve, from: number, to: number, corner: number, search: RayQuery): void {
    const { mesh } = this.object;
    const N = normalize(triangleNormal(mesh, corner));
    const p = pointAt(mesh.positions, mesh.indices[corner]);
    const n = dot(N, this.frame.A);
    const start = dot(N, sub(p, curve.o));
    const rate = dot(N, curve.d);
    const g = (s: number) => start - s * rate + n * this.frame.lag(curve, s);
    const slope = (s: number) => n * this.frame.lagRate(curve, s) - rate;
    const noise = this.frame.noise(curve, to, this.frame.lag(curve, to));
    const turns = slope(from) < 0 !== slope(to) < 0;
    const extremum = turns ? brent(slope, from, to) : to;
    const intervals = turns ? [from, extremum, to] : [from, to];
    for (let i = 0; i + 1 < intervals.length; i++) {
      const s = rootBetween(g, intervals[i], intervals[i + 1], noise);
      if (s !== undefined && this.tryAt(curve, s, slope(s), corner, noise, search)) return;
    }
  }

  private tryAt(
    curve: ObjectRayCurve,
    s: number,
    slope: number,
    corner: number,
    noise: number,
    search: RayQuery,
  ): boolean {
    const { mesh } = this.object;
    const y = addScaled(addScaled(curve.o, curve.d, s), this.frame.A, -this.frame.lag(curve, s));
    for (let i = 0; i < 3; i++) corners.q.set(sub(pointAt(mesh.positions, mesh.indices[corner + i]), y), 3 * i);
    const speed = length(addScaled(curve.d, this.frame.A, -this.frame.lagRate(curve, s)));
    if (!corners.contains(noise, speed, Math.abs(slope))) return false;
    return search.offer(this, s, corner, corners.v, corners.w, slope > 0, 0);
  }
}

function rootBetween(g: (s: number) => number, from: number, to: number, noise: number): number | undefined {
  const [a, b] = [g(from), g(to)];
  if (a < 0 !== b < 0) return brent(g, from, to);
  if (Math.abs(a) <= noise) return from;
  return Math.abs(b) <= noise ? to : undefined;
}
