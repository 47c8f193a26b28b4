import { addBlock, type Stiffness } from '../forces/force.ts';
import type { Matrix } from './conjugateGradients.ts';

/**
 * What implicit steps solve: A = W(I + γ²ββᵀ) + s ∇²V, with W and β of each point: I + γ²ββᵀ is the inverse of I − ββᵀ, by which a force turns into acceleration; on this
 * side the matrix is symmetric. Points that are pinned keep their places. Preconditioned by the inverses of its 3 × 3 blocks.
 */
export class StepMatrix implements Matrix {
  private readonly pinned: Uint8Array;
  private readonly stiffnesses: readonly Stiffness[];
  private readonly s: number;
  private readonly weights: Float64Array;
  /** γβ of each point. */
  private readonly u: Float64Array;
  private readonly inverses: Float64Array;
  private readonly product: Float64Array;

  /** `weights`: W [kg/s² or kg, as s has it]; `u`: γβ. */
  constructor(
    pinned: Uint8Array,
    stiffnesses: readonly Stiffness[],
    s: number,
    weights: Float64Array,
    u: Float64Array,
  ) {
    this.pinned = pinned;
    this.stiffnesses = stiffnesses;
    this.s = s;
    this.weights = weights;
    this.u = u;
    this.inverses = this.invertedBlocks();
    this.product = new Float64Array(u.length);
  }

  multiply(v: Float64Array, out: Float64Array): void {
    const { pinned, weights, u, product, s } = this;
    product.fill(0);
    for (const stiffness of this.stiffnesses) stiffness.multiply(v, product);
    for (let i = 0, j = 0; i < pinned.length; i++, j += 3) {
      const held = pinned[i] ? 0 : 1;
      const uv = u[j] * v[j] + u[j + 1] * v[j + 1] + u[j + 2] * v[j + 2];
      for (let k = j; k < j + 3; k++) out[k] = held * (weights[i] * (v[k] + uv * u[k]) + s * product[k]);
    }
  }

  precondition(v: Float64Array, out: Float64Array): void {
    const { pinned, inverses: b } = this;
    for (let i = 0, j = 0, k = 0; i < pinned.length; i++, j += 3, k += 6) {
      const [x, y, z] = [v[j], v[j + 1], v[j + 2]];
      out[j] = b[k] * x + b[k + 1] * y + b[k + 2] * z;
      out[j + 1] = b[k + 1] * x + b[k + 3] * y + b[k + 4] * z;
      out[j + 2] = b[k + 2] * x + b[k + 4] * y + b[k + 5] * z;
    }
  }

  private invertedBlocks(): Float64Array {
    const { pinned, weights, u, s } = this;
    const blocks = new Float64Array(6 * pinned.length);
    for (const stiffness of this.stiffnesses) stiffness.addBlocks(blocks);
    for (let k = 0; k < blocks.length; k++) blocks[k] *= s;
    for (let i = 0; i < pinned.length; i++) {
      addBlock(blocks, i, weights[i], weights[i], [u[3 * i], u[3 * i + 1], u[3 * i + 2]]);
      invert(blocks, i, weights[i]);
      if (pinned[i]) blocks.fill(0, 6 * i, 6 * i + 6);
    }
    return blocks;
  }
}

/** Inverts a symmetric 3 × 3 block where it is positive definite; else takes 1/W in its stead. */
function invert(blocks: Float64Array, point: number, weight: number): void {
  const k = 6 * point;
  const [a, b, c, d, e, f] = blocks.subarray(k, k + 6);
  const [A, B, C] = [d * f - e * e, c * e - b * f, b * e - c * d];
  const det = a * A + b * B + c * C;
  const good = a > 0 && a * d - b * b > 0 && det > 0;
  const inverse = good ? [A, B, C, a * f - c * c, b * c - a * e, a * d - b * b].map((value) => value / det) : undefined;
  blocks.set(inverse ?? [1 / weight, 0, 0, 1 / weight, 0, 1 / weight], k);
}
