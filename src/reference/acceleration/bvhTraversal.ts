import type { Vec3 } from '../../math/vec3.ts';
import type { Bvh } from './bvh.ts';

/** Covers rounding errors of the slab test, a product of three rounded factors. Source: Ize 2013, "Robust BVH ray traversal". */
const SLACK = 1 + 8 * Number.EPSILON;

/** A balanced tree of 2³² items has 32 levels; items with equal centres are halved too. */
const MAX_DEPTH = 128;

/** Traverses a tree of boxes along a straight line o + s d and returns the leaves that it meets, near ones first. */
export class BvhTraversal {
  private bounds: Float64Array = new Float64Array(0);
  private link: Int32Array = new Int32Array(0);
  private count: Uint8Array = new Uint8Array(0);
  private readonly stack = new Int32Array(MAX_DEPTH);
  private readonly entered = new Float64Array(MAX_DEPTH);
  private top = 0;
  private begin = 0;
  // Per axis: 1/d, the index of the box plane that is met first, and the line's origin for that plane (n) and the opposite one (f).
  private ix = 0;
  private iy = 0;
  private iz = 0;
  private nearX = 0;
  private nearY = 0;
  private nearZ = 0;
  private nx = 0;
  private ny = 0;
  private nz = 0;
  private fx = 0;
  private fy = 0;
  private fz = 0;

  /** Starts at s = `begin`; `line`: o x y z, d x y z, in the frame of the boxes [m]. */
  start(tree: Bvh, line: ArrayLike<number>, begin: number): void {
    this.bounds = tree.bounds;
    this.link = tree.link;
    this.count = tree.count;
    this.begin = begin;
    this.ix = 1 / line[3];
    this.iy = 1 / line[4];
    this.iz = 1 / line[5];
    this.nearX = this.ix < 0 ? 3 : 0;
    this.nearY = this.iy < 0 ? 4 : 1;
    this.nearZ = this.iz < 0 ? 5 : 2;
    this.nx = this.fx = line[0];
    this.ny = this.fy = line[1];
    this.nz = this.fz = line[2];
    this.stack[0] = 0;
    this.entered[0] = this.begin;
    this.top = tree.link.length > 0 ? 1 : 0;
  }

  /** Called after `start`, for a curve that deviates from the line by up to (x, y, z) [m], to that side only; coordinates are accurate to `noise` [m]. */
  thicken([x, y, z]: Vec3, noise: number): void {
    // The thick line meets a box where the line itself meets the box enlarged on the opposite side.
    const [lowX, highX] = [Math.max(0, x) + noise, Math.min(0, x) - noise];
    const [lowY, highY] = [Math.max(0, y) + noise, Math.min(0, y) - noise];
    const [lowZ, highZ] = [Math.max(0, z) + noise, Math.min(0, z) - noise];
    this.nx += this.nearX === 0 ? lowX : highX;
    this.fx += this.nearX === 0 ? highX : lowX;
    this.ny += this.nearY === 1 ? lowY : highY;
    this.fy += this.nearY === 1 ? highY : lowY;
    this.nz += this.nearZ === 2 ? lowZ : highZ;
    this.fz += this.nearZ === 2 ? highZ : lowZ;
  }

  /** The next leaf that is met before s = `end`; −1 if none is left. */
  next(end: number): number {
    const { link, count, stack, entered } = this;
    while (this.top > 0) {
      let node = stack[--this.top];
      if (entered[this.top] > end) continue;
      for (;;) {
        if (count[node] > 0) return node;
        const left = node + 1;
        const right = link[node];
        const a = this.enter(left, end);
        const b = this.enter(right, end);
        if (a === Number.POSITIVE_INFINITY && b === Number.POSITIVE_INFINITY) break;
        this.push(a <= b ? right : left, Math.max(a, b));
        node = a <= b ? left : right;
      }
    }
    return -1;
  }

  private push(node: number, s: number): void {
    if (s === Number.POSITIVE_INFINITY) return;
    this.stack[this.top] = node;
    this.entered[this.top++] = s;
  }

  /** The s at which the line enters a node's box; ∞ if it misses. Written so that NaN (0/0: along a face) counts as inside. */
  private enter(node: number, end: number): number {
    const b = this.bounds;
    const k = 6 * node;
    let near = this.begin;
    let far = end;
    const ax = (b[k + this.nearX] - this.nx) * this.ix;
    const bx = (b[k + 3 - this.nearX] - this.fx) * this.ix;
    const ay = (b[k + this.nearY] - this.ny) * this.iy;
    const by = (b[k + 5 - this.nearY] - this.fy) * this.iy;
    const az = (b[k + this.nearZ] - this.nz) * this.iz;
    const bz = (b[k + 7 - this.nearZ] - this.fz) * this.iz;
    if (ax > near) near = ax;
    if (ay > near) near = ay;
    if (az > near) near = az;
    if (bx < far) far = bx;
    if (by < far) far = by;
    if (bz < far) far = bz;
    return near <= far * SLACK ? near : Number.POSITIVE_INFINITY;
  }
}
