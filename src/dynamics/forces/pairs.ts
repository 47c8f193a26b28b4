import { addScaled, dot, length, sub, type Vec3 } from '../../math/vec3.ts';
import { addBlock, type Force, type PairForceData, type Stiffness, type StiffnessForm } from './force.ts';

/** A potential φ of the distance between two points. */
export interface PairPotential {
  /** Which of the potentials it is, for other implementations. */
  readonly kind: PairForceData['kind'];
  /** k [N/m], or [N m²]. */
  strength(pair: number): number;
  /** L [m] */
  restLength(pair: number): number;
  /** φ(r) [J] */
  energy(r: number, pair: number): number;
  /** φ′(r) [N] */
  derivative(r: number, pair: number): number;
  /** φ″(r) [N/m] */
  secondDerivative(r: number, pair: number): number;
  /** (φ(r₁) − φ(r₀))/(r₁² − r₀²) without cancellation; φ′/2r for r₁ = r₀ [N/m]. */
  discreteDerivative(r0: number, r1: number, pair: number): number;
  /** Upper bound of φ″ and φ′/r, at least 0 [N/m]. */
  maxStiffness(pair: number): number;
}

/**
 * Central forces between many pairs of points: V = Σ φ(|x_i − x_j|). The discrete gradient (φ(r₁) − φ(r₀))/(r₁² −
 * r₀²)·(d₀ + d₁), d = x_i − x_j, conserves momentum, and angular momentum too, since it is symmetric in the ends.
 * @example
 * const pairs = new PairForce(Uint32Array.of(0, 1), new PenaltyPotential(1000, () => 0.5));
 * pairs.energy(Float64Array.of(0, 0, 0, 0.3, 0, 0)); // 20 J
 */
export class PairForce implements Force {
  /** Both ends of each pair. */
  private readonly ends: Uint32Array;
  private readonly potential: PairPotential;

  constructor(ends: Uint32Array, potential: PairPotential) {
    this.ends = ends;
    this.potential = potential;
  }

  get data(): PairForceData {
    const { ends, potential: law } = this;
    const of = (value: (pair: number) => number) => Float64Array.from({ length: ends.length / 2 }, (_, s) => value(s));
    return { kind: law.kind, ends, strengths: of((s) => law.strength(s)), lengths: of((s) => law.restLength(s)) };
  }

  energy(x: Float64Array): number {
    const { ends, potential: law } = this;
    let sum = 0;
    for (let s = 0; 2 * s < ends.length; s++) sum += law.energy(distanceAt(x, 3 * ends[2 * s], 3 * ends[2 * s + 1]), s);
    return sum;
  }

  add(x: Float64Array, sum: Float64Array): void {
    const { ends, potential: law } = this;
    for (let s = 0; 2 * s < ends.length; s++) {
      const i = 3 * ends[2 * s];
      const j = 3 * ends[2 * s + 1];
      const r = distanceAt(x, i, j);
      if (r > 0) addPairForce(sum, i, j, x, x, law.derivative(r, s) / (2 * r));
    }
  }

  addDiscreteGradient(x0: Float64Array, x1: Float64Array, sum: Float64Array): void {
    const { ends, potential: law } = this;
    for (let s = 0; 2 * s < ends.length; s++) {
      const i = 3 * ends[2 * s];
      const j = 3 * ends[2 * s + 1];
      const r0 = distanceAt(x0, i, j);
      const r1 = distanceAt(x1, i, j);
      if (r0 + r1 > 0) addPairForce(sum, i, j, x0, x1, law.discreteDerivative(r0, r1, s));
    }
  }

  stiffness(x: Float64Array, form: StiffnessForm): Stiffness {
    const { ends } = this;
    const count = ends.length / 2;
    /** For each pair: a and b n of a I + b n nᵀ, and n. */
    const known = new Float64Array(5 * count);
    for (let s = 0; s < count; s++) {
      const [i, j] = [3 * ends[2 * s], 3 * ends[2 * s + 1]];
      const r = distanceAt(x, i, j);
      if (r === 0) continue;
      const [across, along] = this.curvatures(r, s, form);
      known[5 * s] = across;
      known[5 * s + 1] = along - across;
      for (let k = 0; k < 3; k++) known[5 * s + 2 + k] = (x[i + k] - x[j + k]) / r;
    }
    return new PairStiffness(ends, known);
  }

  /** φ′/r, across the line between the ends, and φ″, along it. */
  private curvatures(r: number, s: number, form: StiffnessForm): readonly [across: number, along: number] {
    const { potential: law } = this;
    const [across, along] = [law.derivative(r, s) / r, law.secondDerivative(r, s)];
    if (form === 'exact') return [across, along];
    if (form === 'safe') return [Math.max(0, across), Math.max(0, along)];
    // A pair without stiffness may be out of range.
    const k = along > 0 ? law.maxStiffness(s) : 0;
    return [k, k];
  }

  /**
   * The second end of a pair whose ends came nearer than half their contact distance, or passed each other within it.
   */
  findTunneled(x0: Float64Array, x1: Float64Array): number | undefined {
    const { ends, potential: law } = this;
    if (law.kind !== 'penalty') return undefined;
    for (let s = 0; 2 * s < ends.length; s++) {
      const i = 3 * ends[2 * s];
      const j = 3 * ends[2 * s + 1];
      const touch = law.restLength(s);
      const passed = dotProduct(x0, x1, i, j) < 0 && closestApproach(x0, x1, i, j) < touch;
      if (passed || dotProduct(x1, x1, i, j) < (touch * touch) / 4) return ends[2 * s + 1];
    }
    return undefined;
  }

  addStiffnessBound(bound: Float64Array): void {
    const { ends, potential: law } = this;
    for (let s = 0; 2 * s < ends.length; s++) {
      const k = 2 * law.maxStiffness(s);
      bound[ends[2 * s]] += k;
      bound[ends[2 * s + 1]] += k;
    }
  }
}

function distanceAt(x: Float64Array, i: number, j: number): number {
  const dx = x[i] - x[j];
  const dy = x[i + 1] - x[j + 1];
  const dz = x[i + 2] - x[j + 2];
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}

/** d₀·d₁ */
const dotProduct = (x0: Float64Array, x1: Float64Array, i: number, j: number): number =>
  (x0[i] - x0[j]) * (x1[i] - x1[j]) +
  (x0[i + 1] - x0[j + 1]) * (x1[i + 1] - x1[j + 1]) +
  (x0[i + 2] - x0[j + 2]) * (x1[i + 2] - x1[j + 2]);

/** Minimum distance of two points that move straight from x₀ to x₁ and pass each other. */
function closestApproach(x0: Float64Array, x1: Float64Array, i: number, j: number): number {
  const from: Vec3 = [x0[i] - x0[j], x0[i + 1] - x0[j + 1], x0[i + 2] - x0[j + 2]];
  const way = sub([x1[i] - x1[j], x1[i + 1] - x1[j + 1], x1[i + 2] - x1[j + 2]], from);
  return length(addScaled(from, way, -dot(from, way) / dot(way, way)));
}

/** sum −= ±k(d₀ + d₁) */
function addPairForce(sum: Float64Array, i: number, j: number, x0: Float64Array, x1: Float64Array, k: number): void {
  const fx = k * (x0[i] - x0[j] + (x1[i] - x1[j]));
  const fy = k * (x0[i + 1] - x0[j + 1] + (x1[i + 1] - x1[j + 1]));
  const fz = k * (x0[i + 2] - x0[j + 2] + (x1[i + 2] - x1[j + 2]));
  sum[i] -= fx;
  sum[i + 1] -= fy;
  sum[i + 2] -= fz;
  sum[j] += fx;
  sum[j + 1] += fy;
  sum[j + 2] += fz;
}

class PairStiffness implements Stiffness {
  private readonly ends: Uint32Array;
  private readonly known: Float64Array;

  constructor(ends: Uint32Array, known: Float64Array) {
    this.ends = ends;
    this.known = known;
  }

  multiply(u: Float64Array, sum: Float64Array): void {
    const { ends, known } = this;
    for (let s = 0, k = 0; 2 * s < ends.length; s++, k += 5) {
      const i = 3 * ends[2 * s];
      const j = 3 * ends[2 * s + 1];
      const dx = u[i] - u[j];
      const dy = u[i + 1] - u[j + 1];
      const dz = u[i + 2] - u[j + 2];
      const a = known[k];
      const nx = known[k + 2];
      const ny = known[k + 3];
      const nz = known[k + 4];
      const along = known[k + 1] * (dx * nx + dy * ny + dz * nz);
      const fx = a * dx + along * nx;
      const fy = a * dy + along * ny;
      const fz = a * dz + along * nz;
      sum[i] += fx;
      sum[i + 1] += fy;
      sum[i + 2] += fz;
      sum[j] -= fx;
      sum[j + 1] -= fy;
      sum[j + 2] -= fz;
    }
  }

  addBlocks(blocks: Float64Array): void {
    const { ends, known } = this;
    for (let s = 0, k = 0; 2 * s < ends.length; s++, k += 5) {
      for (const end of [ends[2 * s], ends[2 * s + 1]])
        addBlock(blocks, end, known[k], known[k + 1], known[k + 2], known[k + 3], known[k + 4]);
    }
  }
}
