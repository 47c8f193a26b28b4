import { IDENTITY, type Mat3, multiply, transpose } from '../../../math/mat3.ts';
import { norm, type Vec3, ZERO } from '../../../math/vec3.ts';
import type { SpacetimeRay } from '../../acceleration/ray.ts';
import type { CurvedRay } from './rootIsolation.ts';

/** Rounding error of a piece's ends and of balls, as a fraction of the lengths involved. */
const MARGIN = 1e-12;

/** Where the solid's axes are: y → p + M y [m], relative to the motion's origin. */
export interface SolidFrame {
  readonly p: Vec3;
  readonly M: Mat3;
  /** Upper bound of |M|. */
  readonly size: number;
}

/** Upper bound of how much a matrix lengthens, exact for rotations: |M|² = |MᵀM|, which is no more than the greatest sum of a row. */
export function normOf(M: Mat3): number {
  const square = multiply(transpose(M), M);
  const row = (i: number): number => Math.abs(square[i]) + Math.abs(square[i + 1]) + Math.abs(square[i + 2]);
  return Math.sqrt(Math.max(row(0), row(3), row(6)));
}

/** Frobenius norm, an upper bound of how much a matrix lengthens. */
function sizeOf(m: ArrayLike<number>): number {
  let square = 0;
  for (let i = 0; i < 9; i++) square += m[i] * m[i];
  return Math.sqrt(square);
}

const UNIT: SolidFrame = { p: ZERO, M: IDENTITY, size: 1 };

/** The ray during a piece of motion, which is at the fraction f₀ + s f′ at s; one object for all pieces, because they are many. */
export class PieceRay implements CurvedRay {
  readonly y = new Float64Array(3);
  readonly dy = new Float64Array(3);
  speed = 0;
  bend = 0;
  /** The part of the ray that `findStretch` found. */
  first = 0;
  last = 0;
  /** M at the beginning of the piece, and the change of M and p over it. */
  private readonly M = new Float64Array(9);
  private readonly dM = new Float64Array(9);
  private readonly dp = new Float64Array(3);
  /** The ray relative to p, and its rate. */
  private readonly r = new Float64Array(3);
  private readonly dr = new Float64Array(3);
  private readonly inverse = new Float64Array(9);
  private fraction = 0;
  private rate = 0;
  private before = UNIT;
  private after = UNIT;
  private turning = 0;
  /** Whether `inverse` is that of an M of this piece. */
  private isInverted = false;

  /** From s = near of the ray on, which is s = 0 here. */
  start(
    ray: SpacetimeRay,
    near: number,
    origin: Vec3,
    before: SolidFrame,
    after: SolidFrame,
    fraction: number,
    rate: number,
  ): void {
    const { dp, r, dr } = this;
    const { x, dx } = ray;
    for (let i = 0; i < 3; i++) {
      dp[i] = after.p[i] - before.p[i];
      r[i] = x[i] + dx[i] * near - origin[i] - before.p[i] - dp[i] * fraction;
      dr[i] = dx[i] - dp[i] * rate;
    }
    this.before = before;
    this.after = after;
    this.fraction = fraction;
    this.rate = rate;
  }

  /** Sets M, which `findStretch` does not need. */
  setAxes(): void {
    const { M, dM } = this;
    const [from, to] = [this.before.M, this.after.M];
    let square = 0;
    for (let i = 0; i < 9; i++) {
      M[i] = from[i];
      dM[i] = to[i] - from[i];
      square += dM[i] * dM[i];
    }
    this.turning = Math.sqrt(square) * Math.abs(this.rate);
    this.isInverted = false;
  }

  /** How far a point at y in the solid's axes moves over the piece. */
  movedBy(y: Vec3): Vec3 {
    const { dp, dM } = this;
    const along = (i: number): number => dp[i] + dM[3 * i] * y[0] + dM[3 * i + 1] * y[1] + dM[3 * i + 2] * y[2];
    return [along(0), along(1), along(2)];
  }

  /** M at s. */
  matrixAt(s: number): Mat3 {
    const f = this.fraction + s * this.rate;
    const M: number[] = [];
    for (let i = 0; i < 9; i++) M.push(this.M[i] + f * this.dM[i]);
    return M;
  }

  /** Whether the ray is in the ball around the solid in some part of [0, far]; `first` and `last` are that part, with a little beyond. */
  findStretch(radius: number, far: number): boolean {
    const { r, dr } = this;
    const reach = radius * Math.max(this.before.size, this.after.size);
    let [square, along] = [0, 0];
    for (let i = 0; i < 3; i++) {
      square += dr[i] * dr[i];
      along += r[i] * dr[i];
    }
    const nearest = square > 0 ? -along / square : 0;
    let [away, distance] = [0, 0];
    for (let i = 0; i < 3; i++) {
      away += (r[i] + nearest * dr[i]) ** 2;
      distance += r[i] * r[i];
    }
    const most = reach * (1 + MARGIN) + MARGIN * Math.sqrt(distance);
    if (!(away <= most * most)) return false;
    const half = square > 0 ? Math.sqrt((most * most - away) / square) : Number.POSITIVE_INFINITY;
    const margin = MARGIN * (Math.abs(nearest) + reach / Math.sqrt(square || 1));
    this.first = Math.max(-margin, nearest - half);
    this.last = Math.min(far + margin, nearest + half);
    return this.first < this.last && Number.isFinite(this.last - this.first);
  }

  evaluate(s: number): void {
    if (this.turning > 0 || !this.isInverted) this.invertAt(s);
    const { inverse: K, dM, r, dr, rate, y, dy } = this;
    const rx = r[0] + s * dr[0];
    const ry = r[1] + s * dr[1];
    const rz = r[2] + s * dr[2];
    const x = K[0] * rx + K[1] * ry + K[2] * rz;
    const v = K[3] * rx + K[4] * ry + K[5] * rz;
    const z = K[6] * rx + K[7] * ry + K[8] * rz;
    const dx = dr[0] - rate * (dM[0] * x + dM[1] * v + dM[2] * z);
    const dv = dr[1] - rate * (dM[3] * x + dM[4] * v + dM[5] * z);
    const dz = dr[2] - rate * (dM[6] * x + dM[7] * v + dM[8] * z);
    y[0] = x;
    y[1] = v;
    y[2] = z;
    dy[0] = K[0] * dx + K[1] * dv + K[2] * dz;
    dy[1] = K[3] * dx + K[4] * dv + K[5] * dz;
    dy[2] = K[6] * dx + K[7] * dv + K[8] * dz;
  }

  /** Sets `inverse` to that of M at s, without allocating; where M is singular the last one is kept. */
  private invertAt(s: number): void {
    const f = this.fraction + s * this.rate;
    const { M, dM, inverse: K } = this;
    const a = M[0] + f * dM[0];
    const b = M[1] + f * dM[1];
    const c = M[2] + f * dM[2];
    const d = M[3] + f * dM[3];
    const e = M[4] + f * dM[4];
    const g = M[5] + f * dM[5];
    const h = M[6] + f * dM[6];
    const i = M[7] + f * dM[7];
    const j = M[8] + f * dM[8];
    const p = e * j - g * i;
    const q = g * h - d * j;
    const r = d * i - e * h;
    this.isInverted = true;
    const scale = 1 / (a * p + b * q + c * r);
    if (!Number.isFinite(scale)) return;
    K[0] = p * scale;
    K[1] = (c * i - b * j) * scale;
    K[2] = (b * g - c * e) * scale;
    K[3] = q * scale;
    K[4] = (a * j - c * h) * scale;
    K[5] = (c * d - a * g) * scale;
    K[6] = r * scale;
    K[7] = (b * h - a * i) * scale;
    K[8] = (a * e - b * d) * scale;
  }

  /** From y′ = M⁻¹(r′ − M′y) and y″ = −2M⁻¹M′y′, with |M⁻¹| ≤ K₀/(1 − K₀|M′|w) within w of a place where it is K₀. */
  bound(_s: number, half: number): void {
    const { turning } = this;
    const here = sizeOf(this.inverse);
    const inverse = here / (1 - here * turning * half);
    const room = 1 - inverse * turning * half;
    if (!(inverse > 0 && room > 0)) {
      this.speed = this.bend = Number.POSITIVE_INFINITY;
      return;
    }
    const { y, dr } = this;
    this.speed = (inverse * (norm(dr[0], dr[1], dr[2]) + turning * norm(y[0], y[1], y[2]))) / room;
    this.bend = 2 * inverse * turning * this.speed;
  }
}
