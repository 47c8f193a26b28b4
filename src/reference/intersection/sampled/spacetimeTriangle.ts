import { BarycentricTest } from '../barycentrics.ts';

/** Two crossings closer than this fraction of `length` count as one. */
const MIN_SEPARATION = 1e-9;

/**
 * Intersects a ray with a triangle whose corners move straight: relative to the ray they are at q_i(σ) = a_i + b_i σ. The ray is in the
 * triangle's plane where the cubic f(σ) = q₀·(q₁ − q₀) × (q₂ − q₀) is zero, and enters from the front where f rises. docs/physics.md §10.2.
 */
export class SpacetimeTriangle {
  /** [m], 3 per corner. */
  readonly a = new Float64Array(9);
  /** [m per unit of σ] */
  readonly b = new Float64Array(9);
  /** The crossings found by `intersect`, by increasing σ. */
  readonly sigma = new Float64Array(4);
  readonly v = new Float64Array(4);
  readonly w = new Float64Array(4);
  readonly front = [false, false, false, false];
  private found = 0;
  private last = Number.NEGATIVE_INFINITY;
  /** f = c₀ + c₁x + c₂x² + c₃x³ with x = σ/length, 0 … 1. */
  private c0 = 0;
  private c1 = 0;
  private c2 = 0;
  private c3 = 0;
  /** The greatest |N|, N = (q₁ − q₀) × (q₂ − q₀). */
  private area = 0;
  private readonly barycentrics = new BarycentricTest();

  /** Returns the number of crossings with 0 ≤ σ ≤ length; `noise`: accuracy of positions [m]. */
  intersect(length: number, noise: number): number {
    this.found = 0;
    this.last = Number.NEGATIVE_INFINITY;
    this.expand(length);
    const { c0, c1, c2, c3 } = this;
    const close = noise * this.area;
    // The cubic is bounded by its Bernstein coefficients.
    const i = c0 + c1 / 3;
    const j = i + (c1 + c2) / 3;
    const end = c0 + c1 + c2 + c3;
    if (c0 > close && i > close && j > close && end > close) return 0;
    if (c0 < -close && i < -close && j < -close && end < -close) return 0;
    this.search(length, noise, close);
    return this.found;
  }

  /** Computes the coefficients of f, from N = N₀ + N₁σ + N₂σ². */
  private expand(length: number): void {
    const { a, b } = this;
    const ex = a[3] - a[0];
    const ey = a[4] - a[1];
    const ez = a[5] - a[2];
    const gx = a[6] - a[0];
    const gy = a[7] - a[1];
    const gz = a[8] - a[2];
    const fx = (b[3] - b[0]) * length;
    const fy = (b[4] - b[1]) * length;
    const fz = (b[5] - b[2]) * length;
    const hx = (b[6] - b[0]) * length;
    const hy = (b[7] - b[1]) * length;
    const hz = (b[8] - b[2]) * length;
    const kx = ey * gz - ez * gy;
    const ky = ez * gx - ex * gz;
    const kz = ex * gy - ey * gx;
    const lx = ey * hz - ez * hy + fy * gz - fz * gy;
    const ly = ez * hx - ex * hz + fz * gx - fx * gz;
    const lz = ex * hy - ey * hx + fx * gy - fy * gx;
    const mx = fy * hz - fz * hy;
    const my = fz * hx - fx * hz;
    const mz = fx * hy - fy * hx;
    const bx = b[0] * length;
    const by = b[1] * length;
    const bz = b[2] * length;
    this.c0 = a[0] * kx + a[1] * ky + a[2] * kz;
    this.c1 = a[0] * lx + a[1] * ly + a[2] * lz + bx * kx + by * ky + bz * kz;
    this.c2 = a[0] * mx + a[1] * my + a[2] * mz + bx * lx + by * ly + bz * lz;
    this.c3 = bx * mx + by * my + bz * mz;
    const size = (x: number, y: number, z: number) => Math.abs(x) + Math.abs(y) + Math.abs(z);
    this.area = size(kx, ky, kz) + size(lx, ly, lz) + size(mx, my, mz);
  }

  /** Between extrema f is monotonic: it has a root where its sign changes; an end at which |f| ≤ `close` counts as one. */
  private search(length: number, noise: number, close: number): void {
    const { c1, c2, c3 } = this;
    let [first, second] = [1, 1];
    const discriminant = c2 * c2 - 3 * c1 * c3;
    if (discriminant > 0) {
      const q = -(c2 + (c2 < 0 ? -1 : 1) * Math.sqrt(discriminant));
      const [x, y] = [q / (3 * c3), c1 / q];
      if (x > 0 && x < 1) first = x;
      if (y > 0 && y < 1) second = y;
      if (first > second) [first, second] = [second, first];
    }
    this.between(0, first, length, noise, close);
    if (first < 1) this.between(first, second, length, noise, close);
    if (second < 1) this.between(second, 1, length, noise, close);
  }

  private between(from: number, to: number, length: number, noise: number, close: number): void {
    const [a, b] = [this.f(from), this.f(to)];
    if (a < 0 !== b < 0) this.tryAt(this.root(from, to, a, b), length, noise);
    else if (Math.abs(a) <= close) this.tryAt(from, length, noise);
    else if (Math.abs(b) <= close) this.tryAt(to, length, noise);
  }

  private f(x: number): number {
    return this.c0 + x * (this.c1 + x * (this.c2 + x * this.c3));
  }

  private slope(x: number): number {
    return this.c1 + x * (2 * this.c2 + 3 * x * this.c3);
  }

  /** Newton's method, bisecting where a step would leave the bracket; f is monotonic from a = f(lo) to b = f(hi), of opposite signs. */
  private root(lo: number, hi: number, a: number, b: number): number {
    const rising = a < b;
    let x = lo + ((hi - lo) * a) / (a - b);
    for (let i = 0; i < 100; i++) {
      const f = this.f(x);
      if (f === 0) return x;
      if (f < 0 === rising) lo = x;
      else hi = x;
      let next = x - f / this.slope(x);
      if (!(next >= lo && next <= hi)) next = lo + (hi - lo) / 2;
      if (Math.abs(next - x) <= Number.EPSILON * x) return next;
      x = next;
    }
    return x;
  }

  /** Stores the crossing at x if it is inside the triangle and distinct from the last one. */
  private tryAt(x: number, length: number, noise: number): void {
    if (x - this.last < MIN_SEPARATION || this.found === 4) return;
    const { a, b, barycentrics: corners } = this;
    const sigma = x * length;
    for (let k = 0; k < 9; k++) corners.q[k] = a[k] + b[k] * sigma;
    const slope = this.slope(x);
    const speed = Math.sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]) * length;
    if (!corners.contains(noise, speed, Math.abs(slope) / this.area)) return;
    this.last = x;
    this.sigma[this.found] = sigma;
    this.v[this.found] = corners.v;
    this.w[this.found] = corners.w;
    this.front[this.found++] = slope > 0;
  }
}
