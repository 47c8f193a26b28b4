import { addBlock, type Force, type ForceData, type Stiffness, type StiffnessForm } from './force.ts';

/** Springs between points: V = Σ ½k(r − L)². They act instantaneously in the world frame (docs/model.md). */
export interface Springs {
  /** Both ends of each spring. */
  readonly ends: Uint32Array;
  /** k of each [N/m] */
  readonly stiffness: Float64Array;
  /** L of each [m] */
  readonly lengths: Float64Array;
}

/**
 * The force of springs, as fast as it can be.
 * @example
 * // A spring of 100 N/m, stretched from 1 m to 1.2 m.
 * const spring = { ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(100), lengths: Float64Array.of(1) };
 * springForce(spring).energy(Float64Array.of(0, 0, 0, 1.2, 0, 0)); // 2 J
 */
export const springForce = (given: Springs): Force => new SpringForce(given);

/**
 * `PairForce` specialized for springs, which dominate the cost of a step. Springs are stored by one of their ends, so
 * that a point's data is read once for all of its springs. The discrete gradient is that of `PairForce`. (In such loops
 * destructuring arrays costs four times as much as separate statements.)
 */
class SpringForce implements Force {
  readonly data: ForceData;
  private readonly rows: SpringRows;
  private readonly k: Float64Array;
  private readonly L: Float64Array;
  private readonly kL: Float64Array;

  constructor({ ends, stiffness, lengths }: Springs) {
    this.data = { kind: 'spring', ends, strengths: stiffness, lengths };
    const { rows, order } = groupByFirstEnd(ends);
    this.rows = rows;
    this.k = Float64Array.from(order, (s) => stiffness[s]);
    this.L = Float64Array.from(order, (s) => lengths[s]);
    this.kL = this.k.map((k, s) => k * this.L[s]);
  }

  energy(x: Float64Array): number {
    const { k, L } = this;
    const { from, other } = this.rows;
    let sum = 0;
    for (let i = 0, a = 0; a < from.length - 1; a++, i += 3) {
      const xi = x[i];
      const yi = x[i + 1];
      const zi = x[i + 2];
      for (let s = from[a]; s < from[a + 1]; s++) {
        const j = other[s];
        const dx = xi - x[j];
        const dy = yi - x[j + 1];
        const dz = zi - x[j + 2];
        const longer = Math.sqrt(dx * dx + dy * dy + dz * dz) - L[s];
        sum += 0.5 * k[s] * longer * longer;
      }
    }
    return sum;
  }

  /** −∇V of each end: −k(1 − L/r) d */
  add(x: Float64Array, sum: Float64Array): void {
    const { k, kL } = this;
    const { from, other } = this.rows;
    for (let i = 0, a = 0; a < from.length - 1; a++, i += 3) {
      const xi = x[i];
      const yi = x[i + 1];
      const zi = x[i + 2];
      let fx = 0;
      let fy = 0;
      let fz = 0;
      for (let s = from[a]; s < from[a + 1]; s++) {
        const j = other[s];
        const dx = xi - x[j];
        const dy = yi - x[j + 1];
        const dz = zi - x[j + 2];
        const r = Math.sqrt(dx * dx + dy * dy + dz * dz);
        const q = r > 0 ? k[s] - kL[s] / r : 0;
        fx += q * dx;
        fy += q * dy;
        fz += q * dz;
        sum[j] += q * dx;
        sum[j + 1] += q * dy;
        sum[j + 2] += q * dz;
      }
      sum[i] -= fx;
      sum[i + 1] -= fy;
      sum[i + 2] -= fz;
    }
  }

  /** −½k(r₀ + r₁ − 2L)/(r₀ + r₁)·(d₀ + d₁) */
  addDiscreteGradient(x0: Float64Array, x1: Float64Array, sum: Float64Array): void {
    const { k, kL } = this;
    const { from, other } = this.rows;
    for (let i = 0, a = 0; a < from.length - 1; a++, i += 3) {
      const xi0 = x0[i];
      const yi0 = x0[i + 1];
      const zi0 = x0[i + 2];
      const xi1 = x1[i];
      const yi1 = x1[i + 1];
      const zi1 = x1[i + 2];
      let fx = 0;
      let fy = 0;
      let fz = 0;
      for (let s = from[a]; s < from[a + 1]; s++) {
        const j = other[s];
        const dx0 = xi0 - x0[j];
        const dy0 = yi0 - x0[j + 1];
        const dz0 = zi0 - x0[j + 2];
        const dx1 = xi1 - x1[j];
        const dy1 = yi1 - x1[j + 1];
        const dz1 = zi1 - x1[j + 2];
        const both = Math.sqrt(dx0 * dx0 + dy0 * dy0 + dz0 * dz0) + Math.sqrt(dx1 * dx1 + dy1 * dy1 + dz1 * dz1);
        const q = both > 0 ? 0.5 * k[s] - kL[s] / both : 0;
        const qx = q * (dx0 + dx1);
        const qy = q * (dy0 + dy1);
        const qz = q * (dz0 + dz1);
        fx += qx;
        fy += qy;
        fz += qz;
        sum[j] += qx;
        sum[j + 1] += qy;
        sum[j + 2] += qz;
      }
      sum[i] -= fx;
      sum[i + 1] -= fy;
      sum[i + 2] -= fz;
    }
  }

  /** Across: k(1 − L/r), along: k. */
  stiffness(x: Float64Array, form: StiffnessForm, spent?: Stiffness): Stiffness {
    const { k, kL } = this;
    const { from, other } = this.rows;
    const mine = spent instanceof SpringStiffness && spent.rows === this.rows ? spent : undefined;
    const stiffness = mine ?? new SpringStiffness(this.rows, new Float64Array(4 * k.length));
    const { known } = stiffness;
    const safe = form === 'safe';
    const isotropic = form === 'isotropic';
    for (let i = 0, a = 0; a < from.length - 1; a++, i += 3)
      for (let s = from[a]; s < from[a + 1]; s++) {
        const j = other[s];
        const dx = x[i] - x[j];
        const dy = x[i + 1] - x[j + 1];
        const dz = x[i + 2] - x[j + 2];
        const r = Math.sqrt(dx * dx + dy * dy + dz * dz);
        // Springs of zero length with coincident ends have no direction.
        const exact = r > 0 ? k[s] - kL[s] / r : 0;
        const across = isotropic ? k[s] : safe && exact < 0 ? 0 : exact;
        const scale = r > 0 ? Math.sqrt(k[s] - across) / r : 0;
        known[4 * s] = across;
        known[4 * s + 1] = scale * dx;
        known[4 * s + 2] = scale * dy;
        known[4 * s + 3] = scale * dz;
      }
    return stiffness;
  }

  addStiffnessBound(bound: Float64Array): void {
    const { k } = this;
    const { from, other } = this.rows;
    for (let a = 0; a < from.length - 1; a++)
      for (let s = from[a]; s < from[a + 1]; s++) {
        bound[a] += 2 * k[s];
        bound[other[s] / 3] += 2 * k[s];
      }
  }
}

/** Springs grouped by their first ends. */
interface SpringRows {
  /** Start of each point's springs. */
  readonly from: Uint32Array;
  /** Offset of the coordinates of each spring's other end. */
  readonly other: Uint32Array;
}

function groupByFirstEnd(ends: Uint32Array): { readonly rows: SpringRows; readonly order: Uint32Array } {
  const points = ends.reduce((most, end) => Math.max(most, end + 1), 0);
  const count = ends.length / 2;
  const from = new Uint32Array(points + 1);
  for (let s = 0; s < count; s++) from[ends[2 * s] + 1]++;
  for (let a = 0; a < points; a++) from[a + 1] += from[a];
  const free = from.slice();
  const order = new Uint32Array(count);
  for (let s = 0; s < count; s++) order[free[ends[2 * s]]++] = s;
  return { rows: { from, other: order.map((s) => 3 * ends[2 * s + 1]) }, order };
}

/** a I + m mᵀ of each spring: stiffness a across, and |m|² more along it. */
class SpringStiffness implements Stiffness {
  readonly rows: SpringRows;
  /** a and m of each spring. */
  readonly known: Float64Array;

  constructor(rows: SpringRows, known: Float64Array) {
    this.rows = rows;
    this.known = known;
  }

  multiply(u: Float64Array, sum: Float64Array): void {
    const { known } = this;
    const { from, other } = this.rows;
    for (let i = 0, a = 0; a < from.length - 1; a++, i += 3) {
      const ui = u[i];
      const vi = u[i + 1];
      const wi = u[i + 2];
      let fx = 0;
      let fy = 0;
      let fz = 0;
      for (let s = from[a]; s < from[a + 1]; s++) {
        const j = other[s];
        const m = 4 * s;
        const dx = ui - u[j];
        const dy = vi - u[j + 1];
        const dz = wi - u[j + 2];
        const across = known[m];
        const mx = known[m + 1];
        const my = known[m + 2];
        const mz = known[m + 3];
        const along = dx * mx + dy * my + dz * mz;
        const qx = across * dx + along * mx;
        const qy = across * dy + along * my;
        const qz = across * dz + along * mz;
        fx += qx;
        fy += qy;
        fz += qz;
        sum[j] -= qx;
        sum[j + 1] -= qy;
        sum[j + 2] -= qz;
      }
      sum[i] += fx;
      sum[i + 1] += fy;
      sum[i + 2] += fz;
    }
  }

  addBlocks(blocks: Float64Array): void {
    const { known } = this;
    const { from, other } = this.rows;
    for (let a = 0; a < from.length - 1; a++)
      for (let s = from[a]; s < from[a + 1]; s++) {
        const m = 4 * s;
        addBlock(blocks, a, known[m], 1, known[m + 1], known[m + 2], known[m + 3]);
        addBlock(blocks, other[s] / 3, known[m], 1, known[m + 1], known[m + 2], known[m + 3]);
      }
  }
}
