import type { Vec3 } from '../../math/vec3.ts';
import type { Obstacle } from './obstacle.ts';

/** A force with a potential V(x) of the positions. x, y, z of each point; N, m, J. */
export interface Force {
  /** The force as plain data, for other implementations. */
  readonly data: ForceData;
  /** V [J] */
  energy(x: Float64Array): number;
  /** sum −= ∇V */
  add(x: Float64Array, sum: Float64Array): void;
  /**
   * `add` to the points first … end − 1 alone, the same to the bit, bound to its arrays; what it adds to other points is
   * meaningless. Absent: the force needs all points at once. A function that is bound once in a thread is compiled for
   * its arrays (docs/adr/0057-threads-of-cloth.md).
   */
  bind?(x: Float64Array, sum: Float64Array, first: number, end: number): () => void;
  /**
   * sum −= ∇̄V, a discrete gradient: ∇̄V(x₀, x₁)·(x₁ − x₀) = V(x₁) − V(x₀) for any two configurations, and ∇V where
   * they coincide. Source: Gonzalez 1996, J. Nonlinear Sci. 6, 449; Hairer, Lubich, Wanner, "Geometric Numerical
   * Integration", §V.5.
   */
  addDiscreteGradient(x0: Float64Array, x1: Float64Array, sum: Float64Array): void;
  /** `spent`: an earlier result whose buffers may be reused. */
  stiffness(x: Float64Array, form: StiffnessForm, spent?: Stiffness): Stiffness;
  /** bound_i += a bound of Σ_j |∂²V/∂x_i∂x_j| over all positions, for the restoring parts of V [N/m]. */
  addStiffnessBound(bound: Float64Array): void;
  /**
   * Of solids: a point that passed through between x₀ and x₁ within a step, and would now be pushed out on the wrong
   * side.
   */
  findTunneled?(x0: Float64Array, x1: Float64Array): number | undefined;
}

/** The parameters of a force. */
export type ForceData = UniformFieldData | PairForceData | BarrierData | NeighborForceData;

/** A force a_i f on each point: `amounts`, `field`. */
export interface UniformFieldData {
  readonly kind: 'uniform';
  /** a of each point: [kg] in a field of acceleration, [C] in an electric one. */
  readonly amounts: Float64Array;
  /** f [m/s²], or [V/m]. */
  readonly field: Vec3;
}

/** Forces along the line between two points: a spring ½k(r − L)², a penalty, which only repels, or k/r of charges. */
export interface PairForceData {
  /** Which potential. */
  readonly kind: 'spring' | 'penalty' | 'inverse-square';
  /** Both ends of each pair. */
  readonly ends: Uint32Array;
  /** k of each [N/m], or [N m²]. */
  readonly strengths: Float64Array;
  /** L of each [m] */
  readonly lengths: Float64Array;
}

/** ½K(margin − d)² of points nearer to an obstacle than the margin. */
export interface BarrierData {
  readonly kind: 'barrier';
  /** What pushes. */
  readonly obstacle: Obstacle;
  /** Indices of the points that it pushes. */
  readonly points: readonly number[];
  /** K [N/m] */
  readonly strength: number;
  /** How far it reaches [m]. */
  readonly margin: number;
}

/** A penalty between points of different bodies that come near. */
export interface NeighborForceData {
  readonly kind: 'near';
  /** K [N/m] */
  readonly strength: number;
  /** How far it reaches [m]. */
  readonly cutoff: number;
  /** Both ends of all pairs that can come within the cutoff while each point moves by at most `maxTravel` [m]. */
  candidates(x: Float64Array, maxTravel: number): Uint32Array;
}

/**
 * ∇²V: `exact`; `safe`, without its negative parts, hence positive semidefinite; or `isotropic`, with equal stiffness
 * in all directions, as local–global methods approximate it.
 */
export type StiffnessForm = 'exact' | 'safe' | 'isotropic';

/** A Hessian, used through products with displacements. */
export interface Stiffness {
  /** sum += ∇²V u */
  multiply(u: Float64Array, sum: Float64Array): void;
  /** Adds its 3 × 3 diagonal blocks: `blocks` holds six numbers per point, xx, xy, xz, yy, yz, zz. */
  addBlocks(blocks: Float64Array): void;
}

/** Adds a I + b n nᵀ, n = (x, y, z), to the block of a point. */
export function addBlock(
  blocks: Float64Array,
  point: number,
  a: number,
  b: number,
  x: number,
  y: number,
  z: number,
): void {
  const k = 6 * point;
  blocks[k] += a + b * x * x;
  blocks[k + 1] += b * x * y;
  blocks[k + 2] += b * x * z;
  blocks[k + 3] += a + b * y * y;
  blocks[k + 4] += b * y * z;
  blocks[k + 5] += a + b * z * z;
}
