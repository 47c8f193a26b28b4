import { innerProduct } from './inner.ts';

/** Result of a linear solve. */
export interface LinearSolveResult {
  readonly iterations: number;
  /** |r| ≤ tolerance · |b| */
  readonly converged: boolean;
  /** Whether the matrix is not positive definite: a direction u with uᵀAu ≤ 0 was found. */
  readonly indefinite: boolean;
}

/** A symmetric matrix, as products. */
export interface LinearOperator {
  /** out = A u */
  multiply(u: Float64Array, out: Float64Array): void;
  /** out = P⁻¹ u of a symmetric positive definite preconditioner P. */
  precondition(u: Float64Array, out: Float64Array): void;
}

/**
 * A x = b by preconditioned conjugate gradients, starting from the given x. Written here since npm has no maintained
 * sparse solver without WebAssembly, which the page's `script-src 'self'` forbids; and since A changes at every step, a
 * factorization would not be reused. Source: Hestenes and Stiefel 1952; Shewchuk 1994, §B3.
 */
export class ConjugateGradients {
  private readonly r: Float64Array;
  private readonly z: Float64Array;
  private readonly d: Float64Array;
  private readonly Ad: Float64Array;

  constructor(size: number) {
    this.r = new Float64Array(size);
    this.z = new Float64Array(size);
    this.d = new Float64Array(size);
    this.Ad = new Float64Array(size);
  }

  solve(A: LinearOperator, b: Float64Array, x: Float64Array, tolerance: number, most: number): LinearSolveResult {
    const { r, z, d, Ad } = this;
    A.multiply(x, Ad);
    for (let i = 0; i < r.length; i++) r[i] = b[i] - Ad[i];
    A.precondition(r, z);
    d.set(z);
    let rz = innerProduct(r, z);
    let rr = innerProduct(r, r);
    const enough = tolerance * tolerance * innerProduct(b, b);
    for (let iterations = 0; iterations < most; iterations++) {
      if (rr <= enough) return { iterations, converged: true, indefinite: false };
      A.multiply(d, Ad);
      const dAd = innerProduct(d, Ad);
      if (!(dAd > 0)) return { iterations, converged: false, indefinite: true };
      const alpha = rz / dAd;
      rr = 0;
      for (let i = 0; i < r.length; i++) {
        x[i] += alpha * d[i];
        r[i] -= alpha * Ad[i];
        rr += r[i] * r[i];
      }
      A.precondition(r, z);
      const next = innerProduct(r, z);
      const beta = next / rz;
      rz = next;
      for (let i = 0; i < r.length; i++) d[i] = z[i] + beta * d[i];
    }
    return { iterations: most, converged: rr <= enough, indefinite: false };
  }
}
