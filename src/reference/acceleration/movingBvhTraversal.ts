import type { Bvh } from './bvh.ts';

const MAX_DEPTH = 128;

/**
 * Traverses a tree of boxes whose faces move uniformly along a straight line o + s d: at s they are (1 − f) `before` + f `after` with
 * f = f₀ + f₁ s. Returns the leaves that the line meets, near ones first, each with the part of the line inside it.
 */
export class MovingBvhTraversal {
  /** s at which the line enters and leaves the leaf returned last. */
  near = 0;
  far = 0;
  private link: Int32Array = new Int32Array(0);
  private count: Uint8Array = new Uint8Array(0);
  private before: Float64Array = new Float64Array(0);
  private after: Float64Array = new Float64Array(0);
  private readonly stack = new Int32Array(MAX_DEPTH);
  private readonly entered = new Float64Array(MAX_DEPTH);
  private readonly left = new Float64Array(MAX_DEPTH);
  private top = 0;
  private length = 0;
  private noise = 0;
  private readonly o = new Float64Array(3);
  private readonly d = new Float64Array(3);
  private f0 = 0;
  private f1 = 0;

  /** Sets the line and the boxes' motion along it; called before `start`. */
  line(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number, f0: number, f1: number): void {
    const { o, d } = this;
    o[0] = ox;
    o[1] = oy;
    o[2] = oz;
    d[0] = dx;
    d[1] = dy;
    d[2] = dz;
    this.f0 = f0;
    this.f1 = f1;
  }

  /** Starts from s = 0 to `length`; the boxes are enlarged by `noise` [m]. */
  start({ link, count }: Bvh, before: Float64Array, after: Float64Array, length: number, noise: number): void {
    this.link = link;
    this.count = count;
    this.before = before;
    this.after = after;
    this.length = length;
    this.noise = noise;
    this.top = 0;
    if (link.length > 0 && this.intersects(0, length)) this.push(0, this.near, this.far);
  }

  /** The next leaf that is met before s = `end`; −1 if none is left. */
  next(end: number): number {
    while (this.top > 0) {
      const node = this.stack[--this.top];
      if (this.entered[this.top] > end) continue;
      if (this.count[node] > 0) {
        this.near = this.entered[this.top];
        this.far = this.left[this.top];
        return node;
      }
      this.pushChildren(node + 1, this.link[node], end);
    }
    return -1;
  }

  /** Pushes the nearer child last, so that it is popped first. */
  private pushChildren(first: number, second: number, end: number): void {
    const one = this.intersects(first, end);
    const { near, far } = this;
    const other = this.intersects(second, end);
    if (one && other && near > this.near) {
      const [n, f] = [this.near, this.far];
      this.push(first, near, far);
      this.push(second, n, f);
      return;
    }
    if (other) this.push(second, this.near, this.far);
    if (one) this.push(first, near, far);
  }

  private push(node: number, near: number, far: number): void {
    this.stack[this.top] = node;
    this.entered[this.top] = near;
    this.left[this.top++] = far;
  }

  /** Whether the line is ever inside the node's box; if so, sets `near` and `far`. */
  private intersects(node: number, end: number): boolean {
    const { before, after, o, d, f0, f1, noise } = this;
    let near = 0;
    let far = Math.min(end, this.length);
    for (let axis = 0; axis < 3; axis++) {
      const k = 6 * node + axis;
      const lo = before[k];
      const hi = before[k + 3];
      const loMoves = after[k] - lo;
      const hiMoves = after[k + 3] - hi;
      // Distance inside each face, and its rate of change with s.
      const a = o[axis] - lo - loMoves * f0 + noise;
      const aRate = d[axis] - loMoves * f1;
      const b = hi + hiMoves * f0 - o[axis] + noise;
      const bRate = hiMoves * f1 - d[axis];
      if (aRate > 0) near = Math.max(near, -a / aRate);
      else if (aRate < 0) far = Math.min(far, -a / aRate);
      else if (a < 0) return false;
      if (bRate > 0) near = Math.max(near, -b / bRate);
      else if (bRate < 0) far = Math.min(far, -b / bRate);
      else if (b < 0) return false;
      if (near > far) return false;
    }
    this.near = near;
    this.far = far;
    return true;
  }
}
