import { cofactors, determinant, type Mat3, multiply, transform } from '../../../math/mat3.ts';
import { add, scale, sub, type Vec3 } from '../../../math/vec3.ts';
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
import { boxesBetween } from '../../acceleration/timeBvh.ts';
import { PieceSearch } from '../sampled/pieceSearch.ts';
import { Crossings } from './crossings.ts';
import { normOf, PieceRay, type SolidFrame } from './pieceRay.ts';
import { addCurveRoots } from './rootIsolation.ts';
import type { RoundSolid } from './roundSolid.ts';

const crossings = new Crossings();
/** The current piece; and another one, since a search may ask for a hit at each of a piece's crossings. */
const piece = new PieceRay();
const pieceOfHit = new PieceRay();
/** The ball around the solid is a closer bound than boxes of single pieces. */
const PIECES_PER_LEAF = 4;

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
  private readonly frames: readonly SolidFrame[];
  private readonly pieces: PieceSearch;

  constructor(index: number, object: ObjectWith<SampledMotion>, solid: RoundSolid, c: number) {
    const { times } = object.motion;
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.solid = solid;
    this.c = c;
    this.origin = frameAtSample(object, 0, c).position;
    this.frames = Array.from(times, (_, k): SolidFrame => {
      const { position, linear } = frameAtSample(object, k, c);
      const at = add(sub(position, this.origin), transform(linear, solid.place));
      const M = multiply(linear, solid.linear);
      return { p: at, M, size: normOf(M) };
    });
    const boxes = Float64Array.from(this.frames.flatMap(({ p, M }) => boxAround(p, M, solid.extent)));
    this.pieces = new PieceSearch(times, this.origin, boxesBetween(boxes), c, PIECES_PER_LEAF);
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
    this.startPiece(piece, ray, k, near);
    if (!piece.findStretch(this.solid.radius, far - near)) return;
    piece.setAxes();
    const { first, last } = piece;
    crossings.clear();
    addCurveRoots(this.solid, piece, first, last, crossings);
    if (crossings.count === 0) return;
    const contains = (s: number): boolean => {
      piece.evaluate(s);
      return this.solid.contains(piece.y[0], piece.y[1], piece.y[2]);
    };
    crossings.visit(first, last, contains, (s, part, entering) => {
      const at = Math.min(far, Math.max(near, near + s));
      return search.offer(this, at, part, 0, 0, entering, k);
    });
  }

  /** Sets `piece` to the ray in the solid's axes during piece k, from s = near. */
  private startPiece(piece: PieceRay, ray: SpacetimeRay, k: number, near: number): void {
    const { times } = this.object.motion;
    const last = times.length - 1;
    const isMoving = k >= 0 && k < last;
    const span = isMoving ? times[k + 1] - times[k] : 1;
    const rate = isMoving ? ray.dt / (this.c * span) : 0;
    const fraction = isMoving ? (ray.t - times[k]) / span + near * rate : 0;
    piece.start(
      ray,
      near,
      this.origin,
      this.frames[Math.max(0, k)],
      this.frames[Math.min(last, k + 1)],
      fraction,
      rate,
    );
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const { s, piece: k, corner: part } = crossing;
    this.startPiece(pieceOfHit, ray, k, s);
    pieceOfHit.setAxes();
    pieceOfHit.evaluate(0);
    const y: Vec3 = [pieceOfHit.y[0], pieceOfHit.y[1], pieceOfHit.y[2]];
    const moved = pieceOfHit.movedBy(y);
    const [from, to] = this.pieces.timesOf(k);
    const velocity = Number.isFinite(to - from) ? scale(moved, 1 / (this.c * (to - from))) : moved;
    const M = pieceOfHit.matrixAt(0);
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
