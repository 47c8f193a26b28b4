import { addBlock, type Stiffness } from '../forces/force.ts';
import type { LinearOperator } from './conjugateGradients.ts';

/**
 * The matrix of implicit steps: A = W(I + γ²ββᵀ) + ∇²V, with W and β of each point: I + γ²ββᵀ is the inverse of I −
 * ββᵀ, which maps force to acceleration; on this side the matrix is symmetric. Pinned points keep their positions.
 * Preconditioned by the inverses of its 3 × 3 blocks.
 */
export class StepMatrix implements LinearOperator {
  private readonly pinned: Uint8Array;
  private readonly inverses: Float64Array;
  private stiffnesses: readonly Stiffness[] = [];
  private weights: Float64Array = new Float64Array();
  /** γβ of each point. */
  private u: Float64Array = new Float64Array();

  constructor(pinned: Uint8Array) {
    this.pinned = pinned;
    this.inverses = new Float64Array(6 * pinned.length);
  }

  /** `weights`: W [kg/s²]; `u`: γβ. */
  set(stiffnesses: readonly Stiffness[], weights: Float64Array, u: Float64Array): void {
    this.stiffnesses = stiffnesses;
    this.weights = weights;
    this.u = u;
    this.invertBlocks();
  }

  multiply(v: Float64Array, out: Float64Array): void {
    const { pinned, weights, u } = this;
    for (let i = 0, j = 0; i < pinned.length; i++, j += 3) {
      const W = weights[i];
      const uv = u[j] * v[j] + u[j + 1] * v[j + 1] + u[j + 2] * v[j + 2];
      out[j] = W * (v[j] + uv * u[j]);
      out[j + 1] = W * (v[j + 1] + uv * u[j + 1]);
      out[j + 2] = W * (v[j + 2] + uv * u[j + 2]);
    }
    for (const stiffness of this.stiffnesses) stiffness.multiply(v, out);
    for (let i = 0; i < pinned.length; i++) if (pinned[i]) out.fill(0, 3 * i, 3 * i + 3);
  }

  precondition(v: Float64Array, out: Float64Array): void {
    const { pinned, inverses: b } = this;
    for (let i = 0, j = 0, k = 0; i < pinned.length; i++, j += 3, k += 6) {
      const x = v[j];
      const y = v[j + 1];
      const z = v[j + 2];
      out[j] = b[k] * x + b[k + 1] * y + b[k + 2] * z;
      out[j + 1] = b[k + 1] * x + b[k + 3] * y + b[k + 4] * z;
      out[j + 2] = b[k + 2] * x + b[k + 4] * y + b[k + 5] * z;
    }
  }

  private invertBlocks(): void {
    const { pinned, inverses, weights, u } = this;
    inverses.fill(0);
    for (const stiffness of this.stiffnesses) stiffness.addBlocks(inverses);
    for (let i = 0; i < pinned.length; i++) {
      addBlock(inverses, i, weights[i], weights[i], u[3 * i], u[3 * i + 1], u[3 * i + 2]);
      if (pinned[i]) inverses.fill(0, 6 * i, 6 * i + 6);
      else invert(inverses, 6 * i, weights[i]);
    }
  }
}

/** Inverts a symmetric 3 × 3 block if it is positive definite; otherwise uses 1/W. */
function invert(blocks: Float64Array, k: number, weight: number): void {
  const a = blocks[k];
  const b = blocks[k + 1];
  const c = blocks[k + 2];
  const d = blocks[k + 3];
  const e = blocks[k + 4];
  const f = blocks[k + 5];
  const A = d * f - e * e;
  const B = c * e - b * f;
  const C = b * e - c * d;
  const det = a * A + b * B + c * C;
  const minor = a * d - b * b;
  const good = a > 0 && minor > 0 && det > 0;
  blocks[k] = good ? A / det : 1 / weight;
  blocks[k + 1] = good ? B / det : 0;
  blocks[k + 2] = good ? C / det : 0;
  blocks[k + 3] = good ? (a * f - c * c) / det : 1 / weight;
  blocks[k + 4] = good ? (b * c - a * e) / det : 0;
  blocks[k + 5] = good ? minor / det : 1 / weight;
}
