import { add, sub, type Vec3 } from '../../math/vec3.ts';
import type { Mesh } from '../../scene/types.ts';
import { emptyBox, growBox } from '../acceleration/bvh.ts';
import { growByTriangle, type TriangleBvh } from '../acceleration/triangleBvh.ts';
import type { CubicChords } from './cubicChords.ts';

/** An object at one of its samples. */
export interface SampledShape {
  /** 3 per vertex, world axes, from the object's `origin` [m]. */
  readonly points: Float32Array | Float64Array;
  /** The points are not the scene's: they are forgotten with the shape. */
  readonly ownsPoints: boolean;
  /** 6 per node of the tree, as `Bvh.bounds`. */
  readonly boxes: Float64Array;
  /** When it was last asked for. */
  used: number;
}

/** Shapes that are kept: the longest unused are forgotten, and made again when a ray needs them. */
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

  /** Keeps sample k of an object; each of the last two asked for stays, whatever its size. */
  keep(shapes: (SampledShape | undefined)[], k: number, shape: SampledShape): void {
    const bytes = shape.boxes.byteLength + (shape.ownsPoints ? shape.points.byteLength : 0);
    shapes[k] = shape;
    this.touch(shape);
    this.entries.push({ shapes, k, bytes });
    this.bytes += bytes;
    if (this.bytes > this.budget) this.evict();
  }

  /** Down to half, so that this is seldom needed. */
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

/** What the shapes of a kind of sampled motion are made from. */
export interface ShapeSource {
  readonly times: Float64Array;
  /** [m] */
  readonly origin: Vec3;
  /** The tree's structure is one for all samples. */
  readonly topology: TriangleBvh;
  /** The points are not the scene's. */
  readonly ownsPoints: boolean;
  /** Where points go along cubics: its blocks are the pieces. */
  readonly cubic: CubicChords | undefined;
  /** Writes the box of the whole object at sample k, from `origin` [m]; those of rigid objects are not tight. */
  outline(k: number, boxes: Float64Array): void;
  /** 3 per vertex, world axes, from `origin` [m]. */
  pointsAt(k: number): Float32Array | Float64Array;
}

/** The shapes of a sampled object, made when they are asked for. */
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
    const known = this.shapes[k];
    if (known) {
      this.store.touch(known);
      return known;
    }
    const points = this.source.pointsAt(k);
    const made = { points, ownsPoints: this.source.ownsPoints, boxes: this.refit(points), used: 0 };
    this.store.keep(this.shapes, k, made);
    return made;
  }

  /** The boxes of the whole object at all samples, 6 numbers each, from `origin` [m]; those of rigid objects are not tight. */
  outlines(): Float64Array {
    const boxes = new Float64Array(6 * this.times.length);
    for (let k = 0; k < this.times.length; k++) this.source.outline(k, boxes);
    return boxes;
  }

  /** Children come after their parents, so one pass from the end finds all boxes. */
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

  /** Corner i of the triangles at world time t, which lies in piece k (as `SampledRayIntersector` counts them), and its velocity [m/s]. */
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
    const share = (t - this.times[before]) / span;
    const along = (j: number) => this.origin[j] + a[j] + moved[j] * share;
    return { place: [along(0), along(1), along(2)], velocity: [moved[0] / span, moved[1] / span, moved[2] / span] };
  }
}

const pointOf = (points: ArrayLike<number>, i: number): Vec3 => [points[3 * i], points[3 * i + 1], points[3 * i + 2]];
