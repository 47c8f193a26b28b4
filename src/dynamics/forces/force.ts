import type { Vec3 } from '../../math/vec3.ts';
import type { Obstacle } from './obstacle.ts';

/** What has a potential V(x) of the points' places. x, y, z of one point after the other; N, m, J. */
export interface Force {
  /** The same as data, for who computes it elsewhere. */
  readonly data: ForceData;
  /** V [J] */
  energy(x: Float64Array): number;
  /** sum −= ∇V */
  add(x: Float64Array, sum: Float64Array): void;
  /**
   * sum −= ∇̄V, a discrete gradient: ∇̄V(x₀, x₁)·(x₁ − x₀) = V(x₁) − V(x₀) for any two places, and ∇V where they are one.
   * Source: Gonzalez 1996, J. Nonlinear Sci. 6, 449; Hairer, Lubich, Wanner, "Geometric Numerical Integration", §V.5.
   */
  addDiscreteGradient(x0: Float64Array, x1: Float64Array, sum: Float64Array): void;
  /** `spent`: one from before that is needed no more, whose room may be taken. */
  stiffness(x: Float64Array, form: StiffnessForm, spent?: Stiffness): Stiffness;
  /** bound_i += what bounds Σ_j |∂²V/∂x_i∂x_j| wherever the points are, of V's parts that pull back [N/m]. */
  addStiffnessBound(bound: Float64Array): void;
  /** Of what is solid: a point that went through it on its way from x₀ to x₁ within a step, so that it is pushed out on the wrong side from now on. */
  findTunneled?(x0: Float64Array, x1: Float64Array): number | undefined;
}

/** What a force is made of. */
export type ForceData = UniformFieldData | PairForceData | BarrierData | NeighborForceData;

/** a_i f on each point: `amounts`, `field`. */
export interface UniformFieldData {
  readonly kind: 'uniform';
  readonly amounts: Float64Array;
  readonly field: Vec3;
}

/** Along the line between two points: a spring ½k(r − L)², a penalty, which is one that only pushes, or k/r of charges. */
export interface PairForceData {
  readonly kind: 'spring' | 'penalty' | 'inverse-square';
  /** Both ends, pair after pair. */
  readonly ends: Uint32Array;
  /** k of each [N/m], or [N m²]. */
  readonly strengths: Float64Array;
  /** L of each [m] */
  readonly lengths: Float64Array;
}

/** ½K(margin − d)² of points that are nearer to what stands fast than the margin. */
export interface BarrierData {
  readonly kind: 'barrier';
  readonly obstacle: Obstacle;
  readonly points: readonly number[];
  /** K [N/m] */
  readonly strength: number;
  /** [m] */
  readonly margin: number;
}

/** A penalty between points of different bodies, whichever come near. */
export interface NeighborForceData {
  readonly kind: 'near';
  /** K [N/m] */
  readonly strength: number;
  /** [m] */
  readonly cutoff: number;
  /** Both ends of all pairs that can come within reach while each point goes `way` [m] at most. */
  candidates(x: Float64Array, way: number): Uint32Array;
}

/**
 * ∇²V, `exact` at a place; `safe` without its negative parts, so that it pulls back in all directions; or `isotropic`, as if the pull came from a fixed place and were as hard in all
 * directions: what methods that go between local and global steps take for it.
 */
export type StiffnessForm = 'exact' | 'safe' | 'isotropic';

/** A second derivative, as it is used: by products with displacements. */
export interface Stiffness {
  /** sum += ∇²V u */
  multiply(u: Float64Array, sum: Float64Array): void;
  /** Its 3 × 3 blocks on the diagonal: `blocks` holds six numbers a point, xx, xy, xz, yy, yz, zz. */
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
