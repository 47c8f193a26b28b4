import { transform } from '../../../math/mat3.ts';
import { addScaled, dot, length, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import type { ObjectWith } from '../../../scene/motion/kinds/motionKind.ts';
import type { HyperbolicMotion } from '../../../scene/types.ts';
import type { Hit, SpacetimeRay } from '../../acceleration/ray.ts';
import {
  type Crossing,
  clipToTimes,
  createHit,
  type ObjectIntersector,
  type RayQuery,
} from '../../acceleration/rayQuery.ts';
import { convexBulge, HyperbolicFrame, type ObjectRayCurve } from '../hyperbolicFrame.ts';
import { Crossings } from './crossings.ts';
import { addCurveRoots, type CurvedRay } from './rootIsolation.ts';
import type { RoundSolid } from './roundSolid.ts';

const crossings = new Crossings();

/** Greatest distance of a chord from the ray's curve, as a fraction of the solid's radius. */
const MAX_CHORD_ERROR = 0.05;

/** Intersects rays with a round solid in hyperbolic motion: near the solid the ray's curve is nearly straight, and there the roots are isolated. */
export class HyperbolicQuadricIntersector implements ObjectIntersector {
  readonly bounds = undefined;
  readonly index: number;
  readonly doubleSided: boolean;
  private readonly object: ObjectWith<HyperbolicMotion>;
  private readonly solid: RoundSolid;
  private readonly c: number;
  private readonly frame: HyperbolicFrame;
  /** Radius of the ball around the solid [m]. */
  private readonly radius: number;

  constructor(index: number, object: ObjectWith<HyperbolicMotion>, solid: RoundSolid, c: number) {
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.solid = solid;
    this.c = c;
    this.radius = solid.radius * Math.sqrt(solid.linear.reduce((sum, x) => sum + x * x, 0));
    this.frame = new HyperbolicFrame(object, length(solid.place) + this.radius, c);
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    const { birth, death } = this.object.lifetime;
    const curve = this.frame.curveOf(ray);
    const [begin, end] = clipToTimes(ray, birth, death, this.c, search.begin, search.end);
    const [from, to] = this.frame.extent(curve, begin, end);
    if (from < to) this.divide(curve, from, to, search);
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const curve = this.frame.curveOf(ray);
    const path = new HyperbolicRay(this.frame, curve, this.solid);
    path.evaluate(crossing.s);
    const y: Vec3 = [path.y[0], path.y[1], path.y[2]];
    const plane = this.solid.meshNormalAt(y, crossing.corner);
    const { velocity, normal } = this.frame.surfaceAt(curve, crossing.s, plane);
    const at = { ...crossing, ...this.solid.facetAt(y, crossing.corner) };
    return createHit(ray, this.index, at, this.c, velocity, normal);
  }

  /** Halves the curve until chords approximate it, near parts first, and skips parts that miss the ball around the solid. */
  private divide(curve: ObjectRayCurve, from: number, to: number, search: RayQuery): void {
    if (from > search.end) return;
    const { frame } = this;
    const [a, b] = [frame.lag(curve, from), frame.lag(curve, to)];
    const bulge = convexBulge(a, b, frame.lagRate(curve, from), frame.lagRate(curve, to), to - from);
    const middle = from + (to - from) / 2;
    const divisible = middle > from && middle < to;
    if (bulge < Number.POSITIVE_INFINITY || !divisible) {
      const reach = this.radius + (divisible ? bulge : 0) + frame.noise(curve, to, b);
      const stretch = this.nearBall(curve, from, to, a, b, reach);
      if (!stretch) return;
      if (bulge < MAX_CHORD_ERROR * this.radius || !divisible) {
        this.intersectCurve(curve, stretch[0], stretch[1], search);
        return;
      }
    }
    this.divide(curve, from, middle, search);
    this.divide(curve, middle, to, search);
  }

  /** The part of [from, to] in which the chord is within `reach` of the solid's centre; undefined if there is none. */
  private nearBall(
    { o, d }: ObjectRayCurve,
    from: number,
    to: number,
    a: number,
    b: number,
    reach: number,
  ): readonly [number, number] | undefined {
    const { A } = this.frame;
    const begin = sub(addScaled(addScaled(o, d, from), A, -a), this.solid.place);
    const direction = addScaled(d, A, to > from ? -(b - a) / (to - from) : 0);
    const square = dot(direction, direction);
    const nearest = square > 0 ? -dot(begin, direction) / square : 0;
    const away = length(addScaled(begin, direction, nearest));
    if (!(away <= reach)) return undefined;
    const half = square > 0 ? Math.sqrt((reach * reach - away * away) / square) : to - from;
    const [first, last] = [Math.max(from, from + nearest - half), Math.min(to, from + nearest + half)];
    return first <= last ? [first, last] : undefined;
  }

  private intersectCurve(curve: ObjectRayCurve, from: number, to: number, search: RayQuery): void {
    const { solid } = this;
    const path = new HyperbolicRay(this.frame, curve, solid);
    crossings.clear();
    addCurveRoots(solid, path, from, to, crossings);
    const contains = (s: number): boolean => {
      path.evaluate(s);
      return solid.contains(path.y[0], path.y[1], path.y[2]);
    };
    crossings.visit(from, to, contains, (s, part, entering) => search.offer(this, s, part, 0, 0, entering, 0));
  }
}

/** The curve o + s d − A D(s) in the solid's axes. */
class HyperbolicRay implements CurvedRay {
  readonly y = new Float64Array(3);
  readonly dy = new Float64Array(3);
  speed = 0;
  bend = 0;
  private readonly frame: HyperbolicFrame;
  private readonly curve: ObjectRayCurve;
  private readonly solid: RoundSolid;
  /** In the solid's axes. */
  private readonly d: Vec3;
  private readonly A: Vec3;

  constructor(frame: HyperbolicFrame, curve: ObjectRayCurve, solid: RoundSolid) {
    this.frame = frame;
    this.curve = curve;
    this.solid = solid;
    this.d = transform(solid.inverse, curve.d);
    this.A = transform(solid.inverse, frame.A);
  }

  evaluate(s: number): void {
    const { o, d } = this.curve;
    const place = addScaled(addScaled(o, d, s), this.frame.A, -this.frame.lag(this.curve, s));
    this.y.set(transform(this.solid.inverse, sub(place, this.solid.place)));
    this.dy.set(this.rate(s));
  }

  private rate(s: number): Vec3 {
    return addScaled(this.d, this.A, -this.frame.lagRate(this.curve, s));
  }

  /** D is convex, so y′ is between its values at the two ends. */
  bound(s: number, half: number): void {
    this.speed = Math.max(length(this.rate(s - half)), length(this.rate(s + half)));
    this.bend = length(scale(this.A, this.frame.lagBend(this.curve, s - half, s + half)));
    if (!(this.speed >= 0)) this.speed = Number.POSITIVE_INFINITY;
    if (!(this.bend >= 0)) this.bend = Number.POSITIVE_INFINITY;
  }
}
