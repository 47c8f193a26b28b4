import { type Vec3, ZERO } from '../../../math/vec3.ts';
import { samplesUntil } from '../../../physics/worldLines/samples.ts';
import type { Lifetime } from '../../../scene/types.ts';
import type { SpacetimeRay } from '../../acceleration/ray.ts';
import { clipToTimes, type MovingBox } from '../../acceleration/rayQuery.ts';
import { middlePiece, TimeBvh } from '../../acceleration/timeBvh.ts';

/** A tree over 2³¹ pieces has 32 levels. */
const MAX_DEPTH = 64;

/** What `PieceSearch.next` searches: the piece at rest that the ray passes first, those between samples, the other one at rest; nothing any more. */
type Stage = 'first rest' | 'pieces' | 'last rest' | 'none';

/**
 * Finds the pieces of a sampled motion in which a ray may meet the object, in the order in which the ray passes them. Piece k lies between samples k and
 * k + 1; the object is at rest in piece −1, before its first sample, and in the last one, after its last sample.
 */
export class PieceSearch {
  /** The greatest absolute coordinate [m]. */
  readonly reach: number;
  /** The piece that `next` found, and the part of the ray during it. */
  piece = 0;
  near = 0;
  far = 0;
  private readonly times: Float64Array;
  private readonly origin: Vec3;
  private readonly c: number;
  private readonly timeBvh: TimeBvh;
  private stage: Stage = 'none';
  private time = 0;
  /** Change of s for each second along the ray; infinite in a slice of simultaneity. */
  private perSecond = 0;
  private begin = 0;
  private end = 0;
  /** The ray relative to the origin of the object: o x y z, 1/d x y z. */
  private readonly slabs = new Float64Array(6);
  /** Nodes of the tree over time with their first and last piece. */
  private readonly stack = new Int32Array(3 * MAX_DEPTH);
  private top = 0;
  /** How many pieces of the last leaf are left behind `piece`. */
  private left = 0;

  /** `pieceBoxes`: the object's box in each piece relative to `origin`, 6 numbers each [m]. Of a leaf of the tree over time all pieces are found. */
  constructor(times: Float64Array, origin: Vec3, pieceBoxes: Float64Array, c: number, piecesPerLeaf = 1) {
    this.times = times;
    this.origin = origin;
    this.c = c;
    this.timeBvh = new TimeBvh(pieceBoxes, piecesPerLeaf);
    this.reach = Math.max(...this.timeBvh.whole.map(Math.abs));
  }

  get bounds(): MovingBox {
    return { box: Array.from(this.timeBvh.whole, (x, i) => x + this.origin[i % 3]), velocity: ZERO };
  }

  /** When piece k begins and ends [s]. */
  timesOf(k: number): readonly [from: number, to: number] {
    const { times } = this;
    return [
      k < 0 ? Number.NEGATIVE_INFINITY : times[k],
      k < times.length - 1 ? times[k + 1] : Number.POSITIVE_INFINITY,
    ];
  }

  /** Starts the search on a ray, between s = `from` and s = `to`. */
  start(ray: SpacetimeRay, { birth, death }: Lifetime, from: number, to: number): void {
    const { slabs, origin } = this;
    const { x, dx } = ray;
    this.begin = from;
    this.end = to;
    if (birth > Number.NEGATIVE_INFINITY || death < Number.POSITIVE_INFINITY)
      [this.begin, this.end] = clipToTimes(ray, birth, death, this.c, from, to);
    this.time = ray.t;
    this.perSecond = this.c / ray.dt;
    for (let i = 0; i < 3; i++) {
      slabs[i] = x[i] - origin[i];
      slabs[3 + i] = 1 / dx[i];
    }
    this.stage = this.begin > this.end ? 'none' : 'first rest';
    this.left = 0;
    this.top = 0;
    this.push(1, 0, this.timeBvh.pieces - 1);
  }

  /** Whether there is another piece before s = `end`; it is in `piece`, `near` and `far`. */
  next(end: number): boolean {
    const { pieces } = this.timeBvh;
    const isRising = this.perSecond > 0;
    const to = Math.min(end, this.end);
    if (this.stage === 'first rest') {
      if (!Number.isFinite(this.perSecond)) {
        this.stage = 'none';
        return this.take(samplesUntil(this.times, this.time) - 1, this.begin, to);
      }
      this.stage = 'pieces';
      if (this.takeRest(isRising ? -1 : pieces, to)) return true;
    }
    if (this.stage === 'pieces') {
      if (this.nextPiece(to)) return true;
      this.stage = 'last rest';
    }
    if (this.stage === 'none') return false;
    this.stage = 'none';
    return this.takeRest(isRising ? pieces : -1, to);
  }

  private take(piece: number, near: number, far: number): boolean {
    this.piece = piece;
    this.near = near;
    this.far = far;
    return near <= far;
  }

  private takeRest(piece: number, to: number): boolean {
    const { times } = this;
    const edge = this.placeAt(piece < 0 ? times[0] : times[times.length - 1]);
    const isBefore = piece < 0 === this.perSecond > 0;
    return isBefore
      ? this.take(piece, this.begin, Math.min(to, edge))
      : this.take(piece, Math.max(this.begin, edge), to);
  }

  /** Where the ray is at a world time [s]. */
  private placeAt(time: number): number {
    return (time - this.time) * this.perSecond;
  }

  private push(node: number, first: number, last: number): void {
    const { stack } = this;
    const k = 3 * this.top++;
    stack[k] = node;
    stack[k + 1] = first;
    stack[k + 2] = last;
  }

  /** The next piece between samples, in a leaf whose box the ray meets at its time. */
  private nextPiece(to: number): boolean {
    const { stack, times, perSecond } = this;
    const { piecesPerLeaf } = this.timeBvh;
    const isRising = perSecond > 0;
    for (;;) {
      while (this.left > 0) {
        this.left--;
        const piece = this.piece + (isRising ? 1 : -1);
        const one = this.placeAt(times[piece]);
        const other = this.placeAt(times[piece + 1]);
        if (this.take(piece, Math.max(this.begin, isRising ? one : other), Math.min(to, isRising ? other : one)))
          return true;
      }
      if (this.top === 0) return false;
      const k = 3 * --this.top;
      const node = stack[k];
      const first = stack[k + 1];
      const last = stack[k + 2];
      const one = this.placeAt(times[first]);
      const other = this.placeAt(times[last + 1]);
      const near = Math.max(this.begin, isRising ? one : other);
      const far = Math.min(to, isRising ? other : one);
      if (near > far || !this.meets(node, near, far)) continue;
      if (last - first < piecesPerLeaf) {
        this.left = last - first + 1;
        this.piece = isRising ? first - 1 : last + 1;
        continue;
      }
      const middle = middlePiece(first, last);
      if (isRising) this.push(2 * node + 1, middle + 1, last);
      this.push(2 * node, first, middle);
      if (!isRising) this.push(2 * node + 1, middle + 1, last);
    }
  }

  /** Whether the ray is in a node's box anywhere between s = near and s = far. Written so that NaN (0/0: along a face) counts as inside. */
  private meets(node: number, near: number, far: number): boolean {
    const { boxes } = this.timeBvh;
    const { slabs } = this;
    let from = near;
    let to = far;
    for (let axis = 0; axis < 3; axis++) {
      const o = slabs[axis];
      const inverse = slabs[3 + axis];
      const a = (boxes[6 * node + axis] - o) * inverse;
      const b = (boxes[6 * node + 3 + axis] - o) * inverse;
      const enters = inverse < 0 ? b : a;
      const leaves = inverse < 0 ? a : b;
      if (enters > from) from = enters;
      if (leaves < to) to = leaves;
    }
    return from <= to;
  }
}
