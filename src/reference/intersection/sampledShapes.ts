import { add, sub, type Vec3 } from '../../math/vec3.ts';
import type { Mesh } from '../../scene/types.ts';
import { emptyBox, growBox } from '../acceleration/bvh.ts';
import { growByTriangle, type TriangleBvh } from '../acceleration/triangleBvh.ts';
import type { CubicChords } from './cubicChords.ts';

/** An object at one of its samples. */
export interface SampledShape {
  /** 3 per vertex, world axes, relative to the object's `origin` [m]. */
  readonly points: Float32Array | Float64Array;
  /** Whether the points are not the scene's, so that their memory counts as the shape's. */
  readonly ownsPoints: boolean;
  /** 6 per node, as in `Bvh.bounds`. */
  readonly boxes: Float64Array;
  /** Value of the cache's clock at the last use. */
  used: number;
}

/** Least recently used cache of shapes; evicted shapes are evaluated again when a ray needs them. */
export class ShapeCache {
  private readonly budget: number;
  private readonly entries: {
    readonly shapes: (SampledShape | undefined)[];
    readonly k: number;
    readonly bytes: number;
  }[] = [];
  private bytes = 0;
  private clock = 0;

  /** [bytes] */
  constructor(budget: number) {
    this.budget = budget;
  }

  touch(shape: SampledShape): void {
    shape.used = ++this.clock;
  }

  /** Adds sample k of an object; the two most recently used shapes stay whatever their size. */
  keep(shapes: (SampledShape | undefined)[], k: number, shape: SampledShape): void {
    const bytes = shape.boxes.byteLength + (shape.ownsPoints ? shape.points.byteLength : 0);
    shapes[k] = shape;
    this.touch(shape);
    this.entries.push({ shapes, k, bytes });
    this.bytes += bytes;
    if (this.bytes > this.budget) this.evict();
  }

  /** Evicts down to half the budget, so that this is rarely needed. */
  private evict(): void {
    const age = ({ shapes, k }: (typeof this.entries)[number]) => shapes[k]?.used ?? 0;
    this.entries.sort((a, b) => age(b) - age(a));
    while (this.entries.length > 2 && this.bytes > this.budget / 2) {
      const oldest = this.entries.pop();
      if (!oldest) return;
      oldest.shapes[oldest.k] = undefined;
      this.bytes -= oldest.bytes;
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
  /** Whether the points are not the scene's (`SampledShape.ownsPoints`). */
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
  private readonly shapes: (SampledShape | undefined)[];
  private readonly store: ShapeCache;

  constructor(mesh: Mesh, source: ShapeSource, store: ShapeCache) {
    this.mesh = mesh;
    this.source = source;
    this.store = store;
    this.times = source.times;
    this.origin = source.origin;
    this.topology = source.topology;
    this.cubic = source.cubic;
    this.shapes = new Array(this.times.length);
  }

  at(k: number): SampledShape {
    const cached = this.shapes[k];
    if (cached) {
      this.store.touch(cached);
      return cached;
    }
    const points = this.source.pointsAt(k);
    const shape = { points, ownsPoints: this.source.ownsPoints, boxes: this.refit(points), used: 0 };
    this.store.keep(this.shapes, k, shape);
    return shape;
  }

  /** The boxes of the whole object at all samples, 6 numbers each, relative to `origin` [m]; those of rigid objects are not tight. */
  outlines(): Float64Array {
    const boxes = new Float64Array(6 * this.times.length);
    for (let k = 0; k < this.times.length; k++) this.source.outline(k, boxes);
    return boxes;
  }

  /** Children are stored after their parents, so one pass from the end computes all boxes. */
  private refit(points: ArrayLike<number>): Float64Array {
    const { bvh, first } = this.topology;
    const boxes = new Float64Array(bvh.bounds.length);
    for (let node = bvh.link.length - 1; node >= 0; node--) {
      const link = bvh.link[node];
      emptyBox(boxes, 6 * node);
      for (let i = link; i < link + bvh.count[node]; i++)
        growByTriangle(boxes, 6 * node, points, this.mesh.indices, first[i]);
      if (bvh.count[node] === 0) {
        growBox(boxes, 6 * node, boxes, 6 * (node + 1));
        growBox(boxes, 6 * node, boxes, 6 * link);
      }
    }
    return boxes;
  }

  /** Vertex i at world time t in piece k (numbered as in `SampledRayIntersector`), and its velocity [m/s]. */
  vertex(i: number, k: number, t: number): { readonly place: Vec3; readonly velocity: Vec3 } {
    const last = this.times.length - 1;
    const [before, after] = [Math.max(0, k), Math.min(last, k + 1)];
    const a = pointOf(this.at(before).points, i);
    if (before === after) return { place: add(this.origin, a), velocity: [0, 0, 0] };
    const moved = sub(pointOf(this.at(after).points, i), a);
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

const pointOf = (points: ArrayLike<number>, i: number): Vec3 => [points[3 * i], points[3 * i + 1], points[3 * i + 2]];
