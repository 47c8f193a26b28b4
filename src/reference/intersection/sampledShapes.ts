import { add, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import type { Mesh } from '../../scene/types.ts';
import { type Bvh, emptyBox, growBox, meanLeafSize, roundedOutward } from '../acceleration/bvh.ts';
import type { TriangleBvh } from '../acceleration/triangleBvh.ts';
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

/** The BVH of an object for a part of a piece, in its moving coordinates. */
interface PartTree extends CachedShape {
  readonly bvh: Bvh;
}

/** A piece as it is divided for trees: coordinates y = x − f `moved`, f the fraction of the piece, follow the object, and `parts` equal parts of time have trees of their own. */
export interface PieceFrame {
  /** [m] */
  readonly moved: Vec3;
  readonly parts: number;
}

/** Enough for a body of fine triangles that turns by a quarter from sample to sample. */
const MAX_PARTS = 16;
/** Two samples and a tree: what one ray needs at a time. */
const ALWAYS_KEPT = 3;

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
  /** Writes the box of the whole object at sample k, relative to `origin` [m]; those of rigid objects are not tight. */
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
  private readonly mesh: Mesh;
  private readonly source: ShapeSource;
  private readonly store: ShapeCache;
  private readonly samples: (SamplePoints | undefined)[];
  /** `MAX_PARTS` per piece, the piece at rest before the first sample first. */
  private readonly trees: (PartTree | undefined)[];
  private readonly frames: (PieceFrame | undefined)[];
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
    this.trees = new Array(MAX_PARTS * (this.times.length + 1));
    this.frames = new Array(this.times.length + 1);
    this.leafSize = meanLeafSize(this.topology.bvh);
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

  /** The vertices at the beginning and at the end of piece k (numbered as in `SampledRayIntersector`). */
  pointsBefore(k: number): Float32Array | Float64Array {
    return this.pointsAt(Math.max(0, k));
  }

  pointsAfter(k: number): Float32Array | Float64Array {
    return this.pointsAt(Math.min(this.times.length - 1, k + 1));
  }

  /** How piece k is divided: into so many parts that in the moving coordinates no vertex moves by more than the size of a leaf meanwhile. */
  frameOf(k: number): PieceFrame {
    const known = this.frames[k + 1];
    if (known) return known;
    const [before, after] = [this.pointsBefore(k), this.pointsAfter(k)];
    const frame = before === after ? { moved: ZERO, parts: 1 } : this.divided(before, after);
    this.frames[k + 1] = frame;
    return frame;
  }

  private divided(before: ArrayLike<number>, after: ArrayLike<number>): PieceFrame {
    const { first } = this.topology;
    const { indices } = this.mesh;
    const range = new Float64Array(6);
    emptyBox(range, 0);
    for (const at of first)
      for (let corner = at; corner < at + 3; corner++)
        for (let axis = 0; axis < 3; axis++) {
          const moved = after[3 * indices[corner] + axis] - before[3 * indices[corner] + axis];
          if (moved < range[axis]) range[axis] = moved;
          if (moved > range[3 + axis]) range[3 + axis] = moved;
        }
    const middle = (axis: number) => (range[axis] + range[3 + axis]) / 2;
    const spread = Math.max(range[3] - range[0], range[4] - range[1], range[5] - range[2]) / 2;
    const parts = Math.ceil(spread / this.leafSize);
    return {
      moved: [middle(0), middle(1), middle(2)],
      parts: Math.min(MAX_PARTS, Math.max(1, Number.isFinite(parts) ? parts : MAX_PARTS)),
    };
  }

  /** The tree of part number `part` of piece k. */
  treeOf(k: number, part: number): Bvh {
    const at = MAX_PARTS * (k + 1) + part;
    const cached = this.trees[at];
    if (cached) {
      this.store.touch(cached);
      return cached.bvh;
    }
    const bvh = this.refitted(k, part);
    this.store.keep(this.trees, at, { bvh, bytes: bvh.bounds.byteLength + bvh.axis.byteLength, used: 0 });
    return bvh;
  }

  /** The boxes of the whole object at all samples, 6 numbers each, relative to `origin` [m]; those of rigid objects are not tight. */
  outlines(): Float64Array {
    const boxes = new Float64Array(6 * this.times.length);
    for (let k = 0; k < this.times.length; k++) this.source.outline(k, boxes);
    return boxes;
  }

  /** The topology with boxes that contain the triangles throughout the part. Children are stored after their parents, so one pass from the end computes all boxes. */
  private refitted(k: number, part: number): Bvh {
    const { bvh, first } = this.topology;
    const { link, count, order } = bvh;
    const { moved, parts } = this.frameOf(k);
    const [before, after] = [this.pointsBefore(k), this.pointsAfter(k)];
    const ends = [part / parts, (part + 1) / parts];
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
        for (let corner = first[i]; corner < first[i] + 3; corner++)
          this.growByPath(bounds, 6 * node, 3 * this.mesh.indices[corner], before, after, moved, ends);
    }
    return { bounds: roundedOutward(bounds), link, count, axis, order };
  }

  /** Enlarges the box at `to` to contain the vertex at `at` at both fractions of the piece, in its moving coordinates. */
  private growByPath(
    bounds: Float64Array,
    to: number,
    at: number,
    before: ArrayLike<number>,
    after: ArrayLike<number>,
    moved: Vec3,
    ends: readonly number[],
  ): void {
    for (let axis = 0; axis < 3; axis++) {
      const from = before[at + axis];
      const rate = after[at + axis] - from - moved[axis];
      for (const fraction of ends) {
        const y = from + rate * fraction;
        if (y < bounds[to + axis]) bounds[to + axis] = y;
        if (y > bounds[to + 3 + axis]) bounds[to + 3 + axis] = y;
      }
    }
  }

  /** Vertex i at world time t in piece k (numbered as in `SampledRayIntersector`), and its velocity [m/s]. */
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
