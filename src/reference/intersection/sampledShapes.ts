import { toMatrix } from '../../math/quat.ts';
import { add, sub, type Vec3 } from '../../math/vec3.ts';
import { type BoundingBox, boundingBox, sampleBoundingBox } from '../../scene/bounds/bounds.ts';
import { isCubic } from '../../scene/motion/cubicPoints.ts';
import { samplePose } from '../../scene/motion/poses.ts';
import { isStreamed, pointsAt } from '../../scene/streaming/samplePoints.ts';
import type { Mesh, SampledMotion, SampledPointsMotion, SceneObject } from '../../scene/types.ts';
import { emptyBox, growBox } from '../acceleration/bvh.ts';
import { buildTriangleBvh, growByTriangle, meshBvh, type TriangleBvh } from '../acceleration/triangleBvh.ts';
import { CubicChords } from './cubicChords.ts';

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

/** The shapes of a sampled object, made when they are asked for. The tree's structure is one for all samples. */
export class SampledShapes {
  readonly times: Float64Array;
  readonly origin: Vec3;
  readonly topology: TriangleBvh;
  private readonly mesh: Mesh;
  private readonly motion: SampledMotion | SampledPointsMotion;
  private readonly shapes: (SampledShape | undefined)[];
  private readonly store: ShapeCache;
  /** Where points go along cubics: its blocks are the pieces. */
  readonly cubic: CubicChords | undefined;
  private readonly ownsPoints: boolean;

  /** c [m/s]: how much a cubic bends can depend on it. */
  constructor(
    { mesh, motion }: SceneObject & { readonly motion: SampledMotion | SampledPointsMotion },
    store: ShapeCache,
    c: number,
  ) {
    this.mesh = mesh;
    this.motion = motion;
    this.store = store;
    this.cubic = motion.kind === 'sampled-points' && isCubic(motion) ? new CubicChords(motion, c) : undefined;
    this.ownsPoints = motion.kind === 'sampled' || isStreamed(motion.points) || this.cubic !== undefined;
    this.times = this.cubic?.times ?? motion.times;
    this.shapes = new Array(this.times.length);
    this.origin = motion.kind === 'sampled' ? samplePose(motion.poses, 0).position : motion.origin;
    this.topology =
      motion.kind === 'sampled' ? meshBvh(mesh) : buildTriangleBvh({ ...mesh, positions: middlePoints(motion) });
  }

  at(k: number): SampledShape {
    const known = this.shapes[k];
    if (known) {
      this.store.touch(known);
      return known;
    }
    const points = this.pointsAt(k);
    const made = { points, ownsPoints: this.ownsPoints, boxes: this.refit(points), used: 0 };
    this.store.keep(this.shapes, k, made);
    return made;
  }

  /** The boxes of the whole object at all samples, 6 numbers each, from `origin` [m]; those of rigid objects are not tight. */
  outlines(): Float64Array {
    const boxes = new Float64Array(6 * this.times.length);
    for (let k = 0; k < this.times.length; k++) this.outline(k, boxes);
    return boxes;
  }

  private outline(k: number, boxes: Float64Array): void {
    const { motion, cubic } = this;
    if (cubic) {
      cubic.outline(k, boxes);
      return;
    }
    const box = motion.kind === 'sampled' ? boundingBox(this.mesh.positions) : sampleBoundingBox(motion, k);
    if (!box) emptyBox(boxes, 6 * k);
    else if (motion.kind === 'sampled') this.turnedBox(motion, k, box, boxes);
    else boxes.set([...box.min, ...box.max], 6 * k);
  }

  /** |R| takes half the sides of a box to half the sides of the box round it. */
  private turnedBox({ poses }: SampledMotion, k: number, box: BoundingBox, boxes: Float64Array): void {
    const { position, orientation } = samplePose(poses, k);
    const r = toMatrix(orientation);
    const from = sub(position, this.origin);
    for (let i = 0; i < 3; i++) {
      let [middle, half] = [from[i], 0];
      for (let j = 0; j < 3; j++) {
        middle += (r[3 * i + j] * (box.min[j] + box.max[j])) / 2;
        half += (Math.abs(r[3 * i + j]) * (box.max[j] - box.min[j])) / 2;
      }
      boxes[6 * k + i] = middle - half;
      boxes[6 * k + 3 + i] = middle + half;
    }
  }

  private pointsAt(k: number): Float32Array | Float64Array {
    const { motion } = this;
    if (motion.kind === 'sampled-points') return this.cubic?.at(k) ?? pointsAt(motion, k);
    const { position, orientation } = samplePose(motion.poses, k);
    const r = toMatrix(orientation);
    const [px, py, pz] = sub(position, this.origin);
    const from = this.mesh.positions;
    const out = new Float64Array(from.length);
    for (let i = 0; i < from.length; i += 3) {
      const [x, y, z] = [from[i], from[i + 1], from[i + 2]];
      out[i] = px + r[0] * x + r[1] * y + r[2] * z;
      out[i + 1] = py + r[3] * x + r[4] * y + r[5] * z;
      out[i + 2] = pz + r[6] * x + r[7] * y + r[8] * z;
    }
    return out;
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

  /** Corner i of the triangles at world time t, which lies in piece k (as `SampledIntersector` counts them), and its velocity [m/s]. */
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

/** The tree's structure is good for all samples where it fits one in the middle. */
const middlePoints = (motion: SampledPointsMotion): Float32Array => pointsAt(motion, motion.times.length >> 1);
