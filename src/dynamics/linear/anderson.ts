import { inner } from './inner.ts';

/** Rounds that are remembered. */
const DEPTH = 5;

/**
 * Hastens rounds x → x + f(x) towards f = 0: from the last rounds it takes the mixture whose f would be least, were f linear. Source: Anderson 1965, J. ACM 12, 547;
 * Walker and Ni 2011, SIAM J. Numer. Anal. 49, 1715.
 */
export class Anderson {
  private readonly dx: Float64Array[] = [];
  private readonly df: Float64Array[] = [];
  private before: { readonly x: Float64Array; readonly f: Float64Array } | undefined;

  forget(): void {
    this.dx.length = 0;
    this.df.length = 0;
    this.before = undefined;
  }

  /** Changes x to the next one. */
  next(x: Float64Array, f: Float64Array): void {
    const { dx, df, before } = this;
    if (before) {
      dx.unshift(x.map((value, j) => value - before.x[j]));
      df.unshift(f.map((value, j) => value - before.f[j]));
      dx.length = df.length = Math.min(DEPTH, dx.length);
    }
    this.before = { x: x.slice(), f: f.slice() };
    const shares = leastSquares(df, f);
    for (let j = 0; j < x.length; j++) x[j] += f[j];
    shares.forEach((share, k) => {
      const [a, b] = [dx[k], df[k]];
      for (let j = 0; j < x.length; j++) x[j] -= share * (a[j] + b[j]);
    });
  }
}

/** The shares of the columns that come nearest to f, by Gram and Schmidt; columns that tell nothing new have none. */
function leastSquares(columns: readonly Float64Array[], f: Float64Array): number[] {
  const n = columns.length;
  const basis: Float64Array[] = [];
  const R: number[][] = [];
  const y: number[] = [];
  for (const column of columns) {
    const q = column.slice();
    const size = Math.sqrt(inner(q, q));
    const row: number[] = basis.map((other) => {
      const share = inner(other, q);
      for (let j = 0; j < q.length; j++) q[j] -= share * other[j];
      return share;
    });
    const rest = Math.sqrt(inner(q, q));
    const fresh = rest > 1e-10 * size;
    for (let j = 0; j < q.length; j++) q[j] = fresh ? q[j] / rest : 0;
    basis.push(q);
    R.push([...row, fresh ? rest : 0]);
    y.push(inner(q, f));
  }
  const shares = new Array<number>(n).fill(0);
  for (let i = n - 1; i >= 0; i--) {
    let sum = y[i];
    for (let k = i + 1; k < n; k++) sum -= R[k][i] * shares[k];
    shares[i] = R[i][i] > 0 ? sum / R[i][i] : 0;
  }
  return shares;
}
