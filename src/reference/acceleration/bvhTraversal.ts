import type { Vec3 } from '../../math/vec3.ts';
import type { Bvh } from './bvh.ts';

/** Rounding of the three factors of a slab's crossing. Source: Ize 2013, "Robust BVH ray traversal". */
const SLACK = 1 + 8 * Number.EPSILON;

/** Deep enough: a tree of 2³² items that halves would have 32 levels, and lopsided ones are cut by number. */
const MAX_DEPTH = 128;

/**
 * Goes along a straight line o + s d through a tree of boxes and gives the leaves that it meets, near ones first.
 */
export class BvhTraversal {
  private bounds: Float64Array = new Float64Array(0);
  private link: Int32Array = new Int32Array(0);
  private count: Uint8Array = new Uint8Array(0);
  private readonly stack = new Int32Array(MAX_DEPTH);
  private readonly entered = new Float64Array(MAX_DEPTH);
  private top = 0;
  private begin = 0;
  // For each axis: 1/d, which of a box's planes is met first, and where the line begins as that plane (n) and the other one (f) see it.
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

  /** From s = `begin` on; `line`: o x y z, d x y z, in the frame of the boxes [m]. */
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

  /** After `start`: the line stands for a curve that is up to `bulge` [m] beside it on that side, and both are known to `noise` [m]. */
  thicken([x, y, z]: Vec3, noise: number): void {
    // A box is met by some of the thick line where the line itself meets the box made larger to the other side.
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

  /** The next leaf that is met before s = `end`; −1 where there is none left. */
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

  /** The s at which the line enters a node's box; ∞ where it misses it. Written so that NaN (0/0: along a face) counts as inside. */
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
