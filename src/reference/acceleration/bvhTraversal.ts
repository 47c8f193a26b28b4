import type { Vec3 } from '../../math/vec3.ts';
import type { Bvh } from './bvh.ts';

/** Covers rounding errors of the slab test, a product of three rounded factors. Source: Ize 2013, "Robust BVH ray traversal". */
const SLACK = 1 + 8 * Number.EPSILON;

/** A balanced tree of 2³² items has 32 levels; items with equal centres are halved too. */
const MAX_DEPTH = 128;

/**
 * Traverses a tree of boxes along a straight line o + s d and returns the leaves that it meets, of two children the one first that is in front along the
 * axis that divides them. Source: Pharr, Jakob, Humphreys, Physically Based Rendering, 4th ed., §7.3.4.
 */
export class BvhTraversal {
  /** Written by `clip`. */
  near = 0;
  far = 0;
  private tree: Bvh | undefined;
  private readonly stack = new Int32Array(MAX_DEPTH);
  private top = 0;
  private begin = 0;
  /** Per axis: the line's origin for the box plane that is met first, its origin for the opposite one, and 1/d. An array, because fields of numbers are slower. */
  private readonly slabs = new Float64Array(9);
  /** Index in a node's bounds of the plane that is met first, per axis. */
  private nearX = 0;
  private nearY = 0;
  private nearZ = 0;

  /** Starts at s = `begin`; `line`: o x y z, d x y z, in the frame of the boxes [m]. */
  start(tree: Bvh, line: ArrayLike<number>, begin: number): void {
    const { slabs } = this;
    this.tree = tree;
    this.begin = begin;
    slabs[0] = slabs[3] = line[0];
    slabs[1] = slabs[4] = line[1];
    slabs[2] = slabs[5] = line[2];
    slabs[6] = 1 / line[3];
    slabs[7] = 1 / line[4];
    slabs[8] = 1 / line[5];
    this.nearX = slabs[6] < 0 ? 3 : 0;
    this.nearY = slabs[7] < 0 ? 4 : 1;
    this.nearZ = slabs[8] < 0 ? 5 : 2;
    this.stack[0] = 0;
    this.top = tree.link.length > 0 ? 1 : 0;
  }

  /** Called after `start`, for a curve that deviates from the line by up to (x, y, z) [m], to that side only; coordinates are accurate to `noise` [m]. */
  thicken([x, y, z]: Vec3, noise: number): void {
    this.thickenAxis(0, this.nearX === 0, x, noise);
    this.thickenAxis(1, this.nearY === 1, y, noise);
    this.thickenAxis(2, this.nearZ === 2, z, noise);
  }

  /** The thick line meets a box where the line itself meets the box enlarged on the opposite side. */
  private thickenAxis(axis: number, isRising: boolean, deviation: number, noise: number): void {
    const low = Math.max(0, deviation) + noise;
    const high = Math.min(0, deviation) - noise;
    this.slabs[axis] += isRising ? low : high;
    this.slabs[3 + axis] += isRising ? high : low;
  }

  /** Sets `near` and `far` to where the line enters and leaves a node's box, between `begin` and s = `end`; for a node that `next` returned. */
  clip(node: number, end: number): void {
    const { tree, slabs, nearX, nearY, nearZ } = this;
    if (!tree) return;
    const { bounds } = tree;
    const k = 6 * node;
    let near = this.begin;
    let far = end;
    const ax = (bounds[k + nearX] - slabs[0]) * slabs[6];
    const ay = (bounds[k + nearY] - slabs[1]) * slabs[7];
    const az = (bounds[k + nearZ] - slabs[2]) * slabs[8];
    const bx = (bounds[k + 3 - nearX] - slabs[3]) * slabs[6] * SLACK;
    const by = (bounds[k + 5 - nearY] - slabs[4]) * slabs[7] * SLACK;
    const bz = (bounds[k + 7 - nearZ] - slabs[5]) * slabs[8] * SLACK;
    if (ax > near) near = ax;
    if (ay > near) near = ay;
    if (az > near) near = az;
    if (bx < far) far = bx;
    if (by < far) far = by;
    if (bz < far) far = bz;
    this.near = near;
    this.far = Math.max(near, far);
  }

  /** The next leaf that is met before s = `end`; −1 if none is left. Written so that NaN (0/0: along a face) counts as inside. */
  next(end: number): number {
    const { tree, stack, begin, slabs, nearX, nearY, nearZ } = this;
    if (!tree) return -1;
    const { bounds, link, count, axis } = tree;
    const farX = 3 - nearX;
    const farY = 5 - nearY;
    const farZ = 7 - nearZ;
    const nx = slabs[0];
    const ny = slabs[1];
    const nz = slabs[2];
    const fx = slabs[3];
    const fy = slabs[4];
    const fz = slabs[5];
    const ix = slabs[6];
    const iy = slabs[7];
    const iz = slabs[8];
    const ux = ix * SLACK;
    const uy = iy * SLACK;
    const uz = iz * SLACK;
    const last = end * SLACK;
    // Bit i is set if the line runs against axis i, bit 3 + i if it runs along it.
    const against = (nearX === 3 ? 1 : 8) | (nearY === 4 ? 2 : 16) | (nearZ === 5 ? 4 : 32);
    let top = this.top;
    while (top > 0) {
      let node = stack[--top];
      for (;;) {
        const k = 6 * node;
        const ax = (bounds[k + nearX] - nx) * ix;
        const bx = (bounds[k + farX] - fx) * ux;
        if (ax > last || bx < begin) break;
        const ay = (bounds[k + nearY] - ny) * iy;
        const by = (bounds[k + farY] - fy) * uy;
        if (ay > last || by < begin || ax > by || ay > bx) break;
        const az = (bounds[k + nearZ] - nz) * iz;
        const bz = (bounds[k + farZ] - fz) * uz;
        if (az > last || bz < begin || ax > bz || ay > bz || az > bx || az > by) break;
        if (count[node] > 0) {
          this.top = top;
          return node;
        }
        if ((against >> axis[node]) & 1) {
          stack[top++] = node + 1;
          node = link[node];
        } else {
          stack[top++] = link[node];
          node++;
        }
      }
    }
    this.top = 0;
    return -1;
  }
}
