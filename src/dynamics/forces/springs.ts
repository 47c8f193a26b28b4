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
 * `PairForce` specialized for springs, which dominate the cost of a step. Springs are stored by their lower end, so that
 * a point's data is read once for all of its springs, and each point sums its springs in the same order whatever part of
 * the points is computed: first those to lower points, then those to higher ones. The discrete gradient is that of
 * `PairForce`. (In such loops destructuring arrays costs four times as much as separate statements.)
 */
class SpringForce implements Force {
  readonly data: ForceData;
  private readonly rows: SpringRows;
  /** k and kL of each spring, side by side. */
  private readonly law: Float64Array;
  private readonly L: Float64Array;

  constructor({ ends, stiffness, lengths }: Springs) {
    this.data = { kind: 'spring', ends, strengths: stiffness, lengths };
    const { rows, order } = groupByLowerEnd(ends);
    this.rows = rows;
    this.L = Float64Array.from(order, (s) => lengths[s]);
    this.law = new Float64Array(2 * order.length);
    order.forEach((spring, s) => {
      this.law[2 * s] = stiffness[spring];
      this.law[2 * s + 1] = stiffness[spring] * lengths[spring];
    });
  }

  energy(x: Float64Array): number {
    const { law, L } = this;
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
        sum += 0.5 * law[2 * s] * longer * longer;
      }
    }
    return sum;
  }

  add(x: Float64Array, sum: Float64Array): void {
    const { from, other } = this.rows;
    addSprings(x, sum, from, other, this.law, 0, from.length - 1);
  }

  /** A spring across a border of the range is computed on both sides of it. */
  bind(x: Float64Array, sum: Float64Array, first: number, end: number): () => void {
    const { law } = this;
    const { from, other } = this.rows;
    const last = Math.min(end, from.length - 1);
    const start = this.firstRowInto(Math.min(first, last));
    return () => addSprings(x, sum, from, other, law, start, last);
  }

  /** The first point with a spring to `point` or above. */
  private firstRowInto(point: number): number {
    const { from, other } = this.rows;
    for (let a = 0; a < point; a++) for (let s = from[a]; s < from[a + 1]; s++) if (other[s] >= 3 * point) return a;
    return point;
  }

  /** −½k(r₀ + r₁ − 2L)/(r₀ + r₁)·(d₀ + d₁) */
  addDiscreteGradient(x0: Float64Array, x1: Float64Array, sum: Float64Array): void {
    const { law } = this;
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
        const q = both > 0 ? 0.5 * law[2 * s] - law[2 * s + 1] / both : 0;
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
    const { law } = this;
    const { from, other } = this.rows;
    const mine = spent instanceof SpringStiffness && spent.rows === this.rows ? spent : undefined;
    const stiffness = mine ?? new SpringStiffness(this.rows, new Float64Array(2 * law.length));
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
        const k = law[2 * s];
        const exact = r > 0 ? k - law[2 * s + 1] / r : 0;
        const across = isotropic ? k : safe && exact < 0 ? 0 : exact;
        const scale = r > 0 ? Math.sqrt(k - across) / r : 0;
        known[4 * s] = across;
        known[4 * s + 1] = scale * dx;
        known[4 * s + 2] = scale * dy;
        known[4 * s + 3] = scale * dz;
      }
    return stiffness;
  }

  addStiffnessBound(bound: Float64Array): void {
    const { law } = this;
    const { from, other } = this.rows;
    for (let a = 0; a < from.length - 1; a++)
      for (let s = from[a]; s < from[a + 1]; s++) {
        bound[a] += 2 * law[2 * s];
        bound[other[s] / 3] += 2 * law[2 * s];
      }
  }
}

/** −∇V of each end, −k(1 − L/r) d, for the springs whose lower end is first … end − 1. */
function addSprings(
  x: Float64Array,
  sum: Float64Array,
  from: Int32Array,
  other: Int32Array,
  law: Float64Array,
  first: number,
  end: number,
): void {
  for (let i = 3 * first, a = first; a < end; a++, i += 3) {
    const xi = x[i];
    const yi = x[i + 1];
    const zi = x[i + 2];
    let fx = 0;
    let fy = 0;
    let fz = 0;
    const to = from[a + 1];
    for (let s = from[a]; s < to; s++) {
      const j = other[s];
      const dx = xi - x[j];
      const dy = yi - x[j + 1];
      const dz = zi - x[j + 2];
      const r = Math.sqrt(dx * dx + dy * dy + dz * dz);
      const q = r > 0 ? law[2 * s] - law[2 * s + 1] / r : 0;
      const qx = q * dx;
      const qy = q * dy;
      const qz = q * dz;
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

/** Springs grouped by their lower ends. */
interface SpringRows {
  /** Start of each point's springs. */
  readonly from: Int32Array;
  /** Offset of the coordinates of each spring's higher end. */
  readonly other: Int32Array;
}

function groupByLowerEnd(ends: Uint32Array): { readonly rows: SpringRows; readonly order: Int32Array } {
  const lower = (s: number): number => Math.min(ends[2 * s], ends[2 * s + 1]);
  const points = ends.reduce((most, end) => Math.max(most, end + 1), 0);
  const count = ends.length / 2;
  const from = new Int32Array(points + 1);
  for (let s = 0; s < count; s++) from[lower(s) + 1]++;
  for (let a = 0; a < points; a++) from[a + 1] += from[a];
  const free = from.slice();
  const order = new Int32Array(count);
  for (let s = 0; s < count; s++) order[free[lower(s)]++] = s;
  return { rows: { from, other: order.map((s) => 3 * Math.max(ends[2 * s], ends[2 * s + 1])) }, order };
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
