import { cofactors, determinant, type Mat3, multiply, transform } from '../../../math/mat3.ts';
import { add, addScaled, dot, length, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { contraction } from '../../../physics/worldLines/simultaneity.ts';
import type { ObjectWith } from '../../../scene/motion/kinds/motionKind.ts';
import { frameAtSample } from '../../../scene/motion/kinds/sampledMotion.ts';
import type { SampledMotion } from '../../../scene/types.ts';
import type { Hit, SpacetimeRay } from '../../acceleration/ray.ts';
import {
  type Crossing,
  createHit,
  type MovingBox,
  type ObjectIntersector,
  type RayQuery,
} from '../../acceleration/rayQuery.ts';
import { PieceSearch } from '../pieceSearch.ts';
import { Crossings } from './crossings.ts';
import { addCurveRoots, type CurvedRay } from './rootIsolation.ts';
import type { RoundSolid } from './roundSolid.ts';

const crossings = new Crossings();

/** Rounding error of a piece's ends and of balls, as a fraction of the lengths involved. */
const MARGIN = 1e-12;

/** Where the solid's axes are: y → p + M y [m], relative to the motion's origin. */
interface Frame {
  readonly p: Vec3;
  readonly M: Mat3;
}

/**
 * Intersects rays with a round solid at keyframed poses. As the vertices of meshes, its points move straight between samples: the map from its axes to the
 * world is p(f) + M(f) y with p and M linear in the fraction f of the piece, and the ray is there y(s) = M⁻¹(x(s) − p). docs/physics.md §10.4.
 */
export class SampledQuadricIntersector implements ObjectIntersector {
  readonly index: number;
  readonly doubleSided: boolean;
  private readonly object: ObjectWith<SampledMotion>;
  private readonly solid: RoundSolid;
  private readonly c: number;
  private readonly origin: Vec3;
  private readonly frames: readonly Frame[];
  private readonly pieces: PieceSearch;

  constructor(index: number, object: ObjectWith<SampledMotion>, solid: RoundSolid, c: number) {
    const { times } = object.motion;
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.solid = solid;
    this.c = c;
    this.origin = frameAtSample(object, 0, c).position;
    this.frames = Array.from(times, (_, k): Frame => {
      const { position, linear } = frameAtSample(object, k, c);
      const at = add(sub(position, this.origin), transform(linear, solid.place));
      return { p: at, M: multiply(linear, solid.linear) };
    });
    const boxes = Float64Array.from(this.frames.flatMap(({ p, M }) => boxAround(p, M, solid.extent)));
    this.pieces = new PieceSearch(times, this.origin, boxes, c);
  }

  get bounds(): MovingBox {
    return this.pieces.bounds;
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    const { pieces } = this;
    pieces.start(ray, this.object.lifetime, search.begin, search.end);
    while (pieces.next(search.end)) this.tracePiece(ray, pieces.piece, pieces.near, pieces.far, search);
  }

  private tracePiece(ray: SpacetimeRay, k: number, near: number, far: number, search: RayQuery): void {
    const piece = this.pieceOf(ray, k, near);
    const stretch = piece.nearBall(this.solid.radius, far - near);
    if (!stretch) return;
    const [first, last] = stretch;
    crossings.clear();
    addCurveRoots(this.solid, piece, first, last, crossings);
    const contains = (s: number): boolean => {
      piece.evaluate(s);
      return this.solid.contains(piece.y[0], piece.y[1], piece.y[2]);
    };
    crossings.visit(first, last, contains, (s, part, entering) => {
      const at = Math.min(far, Math.max(near, near + s));
      return search.offer(this, at, part, 0, 0, entering, k);
    });
  }

  /** The ray in the solid's axes during piece k, from s = near. */
  private pieceOf(ray: SpacetimeRay, k: number, near: number): PieceRay {
    const last = this.frames.length - 1;
    const [before, after] = [this.frames[Math.max(0, k)], this.frames[Math.min(last, k + 1)]];
    const o = sub(addScaled(ray.x, ray.dx, near), this.origin);
    if (before === after) return new PieceRay(o, ray.dx, before, before, 0, 0);
    const [from, to] = this.pieces.timesOf(k);
    const rate = ray.dt / (this.c * (to - from));
    return new PieceRay(o, ray.dx, before, after, (ray.t - from) / (to - from) + near * rate, rate);
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const { s, piece: k, corner: part } = crossing;
    const piece = this.pieceOf(ray, k, s);
    piece.evaluate(0);
    const y: Vec3 = [piece.y[0], piece.y[1], piece.y[2]];
    const moved = add(piece.dp, transform(piece.dM, y));
    const [from, to] = this.pieces.timesOf(k);
    const velocity = Number.isFinite(to - from) ? scale(moved, 1 / (this.c * (to - from))) : moved;
    const M = piece.at(0);
    const sign = determinant(M) < 0 ? -1 : 1;
    const plane = scale(transform(cofactors(M), this.solid.normalAt(y, part)), sign);
    const at = { ...crossing, ...this.solid.facetAt(y, part) };
    return createHit(ray, this.index, at, this.c, velocity, contraction(plane, properVelocity(velocity)));
  }
}

function boxAround(p: Vec3, M: Mat3, extent: Vec3): number[] {
  const half = [0, 1, 2].map((i) => extent.reduce((sum, e, j) => sum + Math.abs(M[3 * i + j]) * e, 0));
  return [...p.map((x, i) => x - half[i]), ...p.map((x, i) => x + half[i])];
}

/** Frobenius norm, an upper bound of how much a matrix lengthens. */
function sizeOf(m: ArrayLike<number>): number {
  let square = 0;
  for (let i = 0; i < 9; i++) square += m[i] * m[i];
  return Math.sqrt(square);
}

/** The ray o + s d during a piece of motion, which is at the fraction f₀ + s f′ at s. */
class PieceRay implements CurvedRay {
  readonly y = new Float64Array(3);
  readonly dy = new Float64Array(3);
  speed = 0;
  bend = 0;
  /** Change of p and M over the piece. */
  readonly dp: Vec3;
  readonly dM: Mat3;
  private readonly before: Frame;
  private readonly after: Frame;
  /** The ray relative to p, and its rate. */
  private readonly r: Vec3;
  private readonly dr: Vec3;
  private readonly fraction: number;
  private readonly rate: number;
  private readonly turning: number;
  private readonly inverse = new Float64Array(9);

  constructor(o: Vec3, d: Vec3, before: Frame, after: Frame, fraction: number, rate: number) {
    this.before = before;
    this.after = after;
    this.fraction = fraction;
    this.rate = rate;
    this.dp = sub(after.p, before.p);
    this.dM = after.M.map((x, i) => x - before.M[i]);
    this.r = sub(sub(o, before.p), scale(this.dp, fraction));
    this.dr = addScaled(d, this.dp, -rate);
    this.turning = sizeOf(this.dM) * Math.abs(rate);
    this.invertAt(0);
  }

  /** M at s. */
  at(s: number): Mat3 {
    const f = this.fraction + s * this.rate;
    return this.before.M.map((x, i) => x + f * this.dM[i]);
  }

  /** The part of [0, far], with a little beyond, in which the ray is in the ball around the solid; undefined if there is none. */
  nearBall(radius: number, far: number): readonly [number, number] | undefined {
    const { r, dr } = this;
    const reach = radius * Math.max(sizeOf(this.before.M), sizeOf(this.after.M));
    const [square, along] = [dot(dr, dr), dot(r, dr)];
    const nearest = square > 0 ? -along / square : 0;
    const away = length(addScaled(r, dr, nearest));
    const most = reach * (1 + MARGIN) + MARGIN * length(r);
    if (!(away <= most)) return undefined;
    const half = square > 0 ? Math.sqrt((most * most - away * away) / square) : Number.POSITIVE_INFINITY;
    const margin = MARGIN * (Math.abs(nearest) + reach / Math.sqrt(square || 1));
    const [from, to] = [Math.max(-margin, nearest - half), Math.min(far + margin, nearest + half)];
    return from < to && Number.isFinite(to - from) ? [from, to] : undefined;
  }

  evaluate(s: number): void {
    if (this.turning > 0) this.invertAt(s);
    const { inverse: K, dM, r, dr, rate, y, dy } = this;
    const [rx, ry, rz] = [r[0] + s * dr[0], r[1] + s * dr[1], r[2] + s * dr[2]];
    const x = K[0] * rx + K[1] * ry + K[2] * rz;
    const v = K[3] * rx + K[4] * ry + K[5] * rz;
    const z = K[6] * rx + K[7] * ry + K[8] * rz;
    const dx = dr[0] - rate * (dM[0] * x + dM[1] * v + dM[2] * z);
    const dv = dr[1] - rate * (dM[3] * x + dM[4] * v + dM[5] * z);
    const dz = dr[2] - rate * (dM[6] * x + dM[7] * v + dM[8] * z);
    y[0] = x;
    y[1] = v;
    y[2] = z;
    dy[0] = K[0] * dx + K[1] * dv + K[2] * dz;
    dy[1] = K[3] * dx + K[4] * dv + K[5] * dz;
    dy[2] = K[6] * dx + K[7] * dv + K[8] * dz;
  }

  /** Sets `inverse` to that of M at s, without allocating; where M is singular the last one is kept. */
  private invertAt(s: number): void {
    const f = this.fraction + s * this.rate;
    const { dM, inverse: K } = this;
    const { M } = this.before;
    const [a, b, c] = [M[0] + f * dM[0], M[1] + f * dM[1], M[2] + f * dM[2]];
    const [d, e, g] = [M[3] + f * dM[3], M[4] + f * dM[4], M[5] + f * dM[5]];
    const [h, i, j] = [M[6] + f * dM[6], M[7] + f * dM[7], M[8] + f * dM[8]];
    const [p, q, r] = [e * j - g * i, g * h - d * j, d * i - e * h];
    const scale = 1 / (a * p + b * q + c * r);
    if (!Number.isFinite(scale)) return;
    K[0] = p * scale;
    K[1] = (c * i - b * j) * scale;
    K[2] = (b * g - c * e) * scale;
    K[3] = q * scale;
    K[4] = (a * j - c * h) * scale;
    K[5] = (c * d - a * g) * scale;
    K[6] = r * scale;
    K[7] = (b * h - a * i) * scale;
    K[8] = (a * e - b * d) * scale;
  }

  /** From y′ = M⁻¹(r′ − M′y) and y″ = −2M⁻¹M′y′, with |M⁻¹| ≤ K₀/(1 − K₀|M′|w) within w of a place where it is K₀. */
  bound(_s: number, half: number): void {
    const { turning } = this;
    const here = sizeOf(this.inverse);
    const inverse = here / (1 - here * turning * half);
    const room = 1 - inverse * turning * half;
    if (!(inverse > 0 && room > 0)) {
      this.speed = this.bend = Number.POSITIVE_INFINITY;
      return;
    }
    const [x, y, z] = this.y;
    this.speed = (inverse * (length(this.dr) + turning * Math.hypot(x, y, z))) / room;
    this.bend = 2 * inverse * turning * this.speed;
  }
}
