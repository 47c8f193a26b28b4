import { add, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import type { Mesh } from '../../../scene/types.ts';
import { type Bvh, emptyBox, growBox, meanLeafSize, roundedOutward } from '../../acceleration/bvh.ts';
import type { TriangleBvh } from '../../acceleration/triangleBvh.ts';
import type { CubicChords } from './cubicChords.ts';
import type { MovingVertex } from './sampledCrossings.ts';

/** What a `ShapeCache` holds. */
interface CachedShape {
  /** Memory that is not the scene's [bytes]. */
  readonly bytes: number;
  /** Value of the cache's clock at the last use. */
  used: number;
}

/** The vertices of an object at one of its samples. */
interface SamplePoints extends CachedShape {
  /** 3 per vertex, world axes, relative to the object's `origin` [m]. */
  readonly points: Float32Array | Float64Array;
}

/** The BVH of an object for a part of a block, in its moving coordinates. */
interface PartTree extends CachedShape {
  readonly bvh: Bvh;
}

/** A block as it is divided for trees: coordinates y = x − f `moved`, f the fraction of the block, follow the object, and `parts` equal parts of time have trees of their own. */
export interface BlockFrame {
  /** [m] */
  readonly moved: Vec3;
  readonly parts: number;
}

/** The vertices at a fraction of a block: those of `before` with the weight 1 − w, and those of `after`. */
interface BlockKey {
  readonly before: ArrayLike<number>;
  readonly after: ArrayLike<number>;
  readonly w: number;
  readonly fraction: number;
}

/** Of slow motion so many pieces share a tree. */
export const MAX_PIECES_PER_BLOCK = 8;
/** Enough for a body of fine triangles that turns by a quarter from sample to sample. */
const MAX_PARTS = 16;
/** The samples and the tree of a block: what one ray needs at a time. */
const ALWAYS_KEPT = MAX_PIECES_PER_BLOCK + 2;

/** Least recently used cache of shapes; evicted shapes are evaluated again when a ray needs them. */
export class ShapeCache {
  private readonly budget: number;
  private readonly entries: { readonly shapes: (CachedShape | undefined)[]; readonly k: number }[] = [];
  private bytes = 0;
  private clock = 0;

  /** [bytes] */
  constructor(budget: number) {
    this.budget = budget;
  }

  touch(shape: CachedShape): void {
    shape.used = ++this.clock;
  }

  /** Adds shape k of an object's list; the most recently used shapes stay whatever their size. */
  keep<T extends CachedShape>(shapes: (T | undefined)[], k: number, shape: T): void {
    shapes[k] = shape;
    this.touch(shape);
    this.entries.push({ shapes, k });
    this.bytes += shape.bytes;
    if (this.bytes > this.budget) this.evict();
  }

  /** Evicts down to half the budget, so that this is rarely needed. */
  private evict(): void {
    const age = ({ shapes, k }: (typeof this.entries)[number]) => shapes[k]?.used ?? 0;
    this.entries.sort((a, b) => age(b) - age(a));
    while (this.entries.length > ALWAYS_KEPT && this.bytes > this.budget / 2) {
      const oldest = this.entries.pop();
      if (!oldest) return;
      this.bytes -= oldest.shapes[oldest.k]?.bytes ?? 0;
      oldest.shapes[oldest.k] = undefined;
    }
  }
}

/** Evaluates shapes of one kind of sampled motion. */
export interface ShapeSource {
  readonly times: Float64Array;
  /** [m] */
  readonly origin: Vec3;
  /** One BVH topology for all samples. */
  readonly topology: TriangleBvh;
  /** Whether the points are not the scene's, so that their memory counts. */
  readonly ownsPoints: boolean;
  /** Defined if points move along cubics; then its blocks are the pieces. */
  readonly cubic: CubicChords | undefined;
  /** Writes the box of the whole object at sample k, relative to `origin` [m]. */
  outline(k: number, boxes: Float64Array): void;
  /** 3 per vertex, world axes, relative to `origin` [m]. */
  pointsAt(k: number): Float32Array | Float64Array;
}

/** The shapes of a sampled object, evaluated lazily. */
export class SampledShapes {
  readonly times: Float64Array;
  readonly origin: Vec3;
  readonly topology: TriangleBvh;
  readonly cubic: CubicChords | undefined;
  /** Block j is between samples `blockEnds[j]` and `blockEnds[j + 1]`; block −1 is the rest before the first sample, the last one that after the last. */
  readonly blockEnds: Int32Array;
  private readonly mesh: Mesh;
  private readonly source: ShapeSource;
  private readonly store: ShapeCache;
  private readonly samples: (SamplePoints | undefined)[];
  /** `MAX_PARTS` per block, the piece at rest before the first sample first. */
  private readonly trees: (PartTree | undefined)[];
  private readonly frames: (BlockFrame | undefined)[];
  /** Mean of the longest sides of leaves [m]. */
  private readonly leafSize: number;

  constructor(mesh: Mesh, source: ShapeSource, store: ShapeCache) {
    this.mesh = mesh;
    this.source = source;
    this.store = store;
    this.times = source.times;
    this.origin = source.origin;
    this.topology = source.topology;
    this.cubic = source.cubic;
    this.samples = new Array(this.times.length);
    this.leafSize = meanLeafSize(this.topology.bvh);
    this.blockEnds = blockEnds(this.times.length - 1, this.cubic ? 1 : this.piecesPerBlock());
    this.trees = new Array(MAX_PARTS * (this.blockEnds.length + 1));
    this.frames = new Array(this.blockEnds.length + 1);
  }

  /** So many that in the middle of the motion no vertex moves by more than the size of a leaf in a block, relative to the others. */
  private piecesPerBlock(): number {
    const middle = (this.times.length - 1) >> 1;
    const { spread } = this.movement(this.pointsAt(middle), this.pointsAt(middle + 1));
    const pieces = Math.floor(this.leafSize / spread);
    return Number.isFinite(pieces) ? Math.min(MAX_PIECES_PER_BLOCK, Math.max(1, pieces)) : MAX_PIECES_PER_BLOCK;
  }

  /** The vertices at sample k: 3 per vertex, world axes, relative to `origin` [m]. */
  pointsAt(k: number): Float32Array | Float64Array {
    const cached = this.samples[k];
    if (cached) {
      this.store.touch(cached);
      return cached.points;
    }
    const points = this.source.pointsAt(k);
    this.store.keep(this.samples, k, { points, bytes: this.source.ownsPoints ? points.byteLength : 0, used: 0 });
    return points;
  }

  /** The first and the last sample of a block. */
  private endsOf(block: number): readonly [first: number, last: number] {
    const { blockEnds } = this;
    const last = blockEnds.length - 1;
    return [blockEnds[Math.max(0, block)], blockEnds[Math.min(last, block + 1)]];
  }

  /** The first and the last piece of a block. */
  piecesOf(block: number): readonly [first: number, last: number] {
    const { blockEnds } = this;
    const isMoving = block >= 0 && block + 1 < blockEnds.length;
    if (isMoving) return [blockEnds[block], blockEnds[block + 1] - 1];
    const rest = block < 0 ? -1 : this.times.length - 1;
    return [rest, rest];
  }

  /** How a block is divided: into so many parts that in the moving coordinates no vertex moves by more than the size of a leaf meanwhile. */
  frameOf(block: number): BlockFrame {
    const known = this.frames[block + 1];
    if (known) return known;
    const [first, last] = this.endsOf(block);
    const { moved, spread } =
      first === last ? { moved: ZERO, spread: 0 } : this.movement(this.pointsAt(first), this.pointsAt(last));
    const parts = last - first === 1 ? Math.ceil(spread / this.leafSize) : 1;
    const frame = { moved, parts: Math.min(MAX_PARTS, Math.max(1, Number.isFinite(parts) ? parts : MAX_PARTS)) };
    this.frames[block + 1] = frame;
    return frame;
  }

  /** The middle of all vertices' displacements, and the greatest difference from it along an axis [m]. */
  private movement(
    before: ArrayLike<number>,
    after: ArrayLike<number>,
  ): { readonly moved: Vec3; readonly spread: number } {
    const { indices } = this.mesh;
    const range = new Float64Array(6);
    emptyBox(range, 0);
    for (const at of this.topology.first)
      for (let corner = at; corner < at + 3; corner++)
        for (let axis = 0; axis < 3; axis++) {
          const moved = after[3 * indices[corner] + axis] - before[3 * indices[corner] + axis];
          if (moved < range[axis]) range[axis] = moved;
          if (moved > range[3 + axis]) range[3 + axis] = moved;
        }
    const middle = (axis: number) => (range[axis] + range[3 + axis]) / 2;
    const spread = Math.max(range[3] - range[0], range[4] - range[1], range[5] - range[2]) / 2;
    return { moved: [middle(0), middle(1), middle(2)], spread };
  }

  /** The tree of part number `part` of a block. */
  treeOf(block: number, part: number): Bvh {
    const at = MAX_PARTS * (block + 1) + part;
    const cached = this.trees[at];
    if (cached) {
      this.store.touch(cached);
      return cached.bvh;
    }
    const bvh = this.refitted(this.frameOf(block), this.keysOf(block, part));
    this.store.keep(this.trees, at, { bvh, bytes: bvh.bounds.byteLength + bvh.axis.byteLength, used: 0 });
    return bvh;
  }

  /** Between these, vertices move straight during a part of a block. */
  private keysOf(block: number, part: number): BlockKey[] {
    const { times } = this;
    const { parts } = this.frameOf(block);
    const [first, last] = this.endsOf(block);
    const [before, after] = [this.pointsAt(first), this.pointsAt(last)];
    if (parts > 1) return [part, part + 1].map((j) => ({ before, after, w: j / parts, fraction: j / parts }));
    return Array.from({ length: last - first + 1 }, (_, j): BlockKey => {
      const points = this.pointsAt(first + j);
      const fraction = first === last ? 0 : (times[first + j] - times[first]) / (times[last] - times[first]);
      return { before: points, after: points, w: 0, fraction };
    });
  }

  /** The boxes of the whole object in all blocks, 6 numbers each, relative to `origin` [m]. */
  blockBoxes(): Float64Array {
    const outlines = this.outlines();
    const blocks = this.blockEnds.length - 1;
    const boxes = new Float64Array(6 * blocks);
    for (let block = 0; block < blocks; block++) {
      const [first, last] = this.endsOf(block);
      emptyBox(boxes, 6 * block);
      for (let k = first; k <= last; k++) growBox(boxes, 6 * block, outlines, 6 * k);
    }
    return boxes;
  }

  private outlines(): Float64Array {
    const boxes = new Float64Array(6 * this.times.length);
    for (let k = 0; k < this.times.length; k++) this.source.outline(k, boxes);
    return boxes;
  }

  /** The topology with boxes that contain the triangles at all keys. Children are stored after their parents, so one pass from the end computes all boxes. */
  private refitted({ moved }: BlockFrame, keys: readonly BlockKey[]): Bvh {
    const { bvh, first } = this.topology;
    const { indices } = this.mesh;
    const { link, count, order } = bvh;
    const bounds = new Float64Array(bvh.bounds.length);
    const axis = new Uint8Array(bvh.axis.length);
    for (let node = link.length - 1; node >= 0; node--) {
      emptyBox(bounds, 6 * node);
      if (count[node] === 0) {
        growBox(bounds, 6 * node, bounds, 6 * (node + 1));
        growBox(bounds, 6 * node, bounds, 6 * link[node]);
        axis[node] = dividingAxis(bounds, 6 * (node + 1), 6 * link[node]);
      }
      for (let i = link[node]; i < link[node] + count[node]; i++)
        for (const key of keys)
          for (let corner = first[i]; corner < first[i] + 3; corner++)
            growByKey(bounds, 6 * node, 3 * indices[corner], key, moved);
    }
    return { bounds: roundedOutward(bounds), link, count, axis, order };
  }

  /** Vertex i at world time t in piece k (numbered as in `SampledPointsRayIntersector`), and its velocity [m/s]. */
  vertex(i: number, k: number, t: number): MovingVertex {
    const last = this.times.length - 1;
    const [before, after] = [Math.max(0, k), Math.min(last, k + 1)];
    const a = pointOf(this.pointsAt(before), i);
    if (before === after) return { place: add(this.origin, a), velocity: [0, 0, 0] };
    const moved = sub(pointOf(this.pointsAt(after), i), a);
    if (this.cubic) {
      const { x, v } = this.cubic.point(i, t);
      return { place: add(this.origin, x), velocity: v };
    }
    const span = this.times[after] - this.times[before];
    const fraction = (t - this.times[before]) / span;
    const along = (j: number) => this.origin[j] + a[j] + moved[j] * fraction;
    return { place: [along(0), along(1), along(2)], velocity: [moved[0] / span, moved[1] / span, moved[2] / span] };
  }
}

/** Enlarges the box at `to` to contain the vertex at `at`, in the moving coordinates of a block. */
function growByKey(
  bounds: Float64Array,
  to: number,
  at: number,
  { before, after, w, fraction }: BlockKey,
  moved: Vec3,
): void {
  for (let axis = 0; axis < 3; axis++) {
    const from = before[at + axis];
    const y = from + (after[at + axis] - from) * w - moved[axis] * fraction;
    if (y < bounds[to + axis]) bounds[to + axis] = y;
    if (y > bounds[to + 3 + axis]) bounds[to + 3 + axis] = y;
  }
}

function blockEnds(pieces: number, perBlock: number): Int32Array {
  const blocks = Math.ceil(pieces / perBlock);
  return Int32Array.from({ length: blocks + 1 }, (_, j) => Math.min(pieces, j * perBlock));
}

/** As in `Bvh.axis`, that along which the centres of the boxes of both children are farthest apart. */
function dividingAxis(bounds: Float64Array, left: number, right: number): number {
  let [best, most] = [0, 0];
  for (let axis = 0; axis < 3; axis++) {
    const apart = bounds[right + axis] + bounds[right + 3 + axis] - bounds[left + axis] - bounds[left + 3 + axis];
    if (Math.abs(apart) > most) [best, most] = [apart < 0 ? 3 + axis : axis, Math.abs(apart)];
  }
  return best;
}

const pointOf = (points: ArrayLike<number>, i: number): Vec3 => [points[3 * i], points[3 * i + 1], points[3 * i + 2]];
