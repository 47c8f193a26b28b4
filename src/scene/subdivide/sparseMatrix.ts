/** A sparse matrix in compressed rows: row r has the weights `starts[r]` to `starts[r + 1]`, each with its column. */
export interface SparseMatrix {
  readonly starts: Uint32Array;
  readonly columns: Uint32Array;
  readonly weights: Float64Array;
}

/** Builds a matrix row by row. */
export class SparseMatrixBuilder {
  private readonly starts: Uint32Array;
  private columns: Uint32Array;
  private weights: Float64Array;
  private rows = 0;
  private size = 0;

  /** `perRow`: expected weights per row; not a limit. */
  constructor(rows: number, perRow: number) {
    this.starts = new Uint32Array(rows + 1);
    this.columns = new Uint32Array(rows * perRow + 16);
    this.weights = new Float64Array(rows * perRow + 16);
  }

  add(column: number, weight: number): void {
    if (this.size === this.columns.length) this.grow();
    this.columns[this.size] = column;
    this.weights[this.size++] = weight;
  }

  endRow(): void {
    this.starts[++this.rows] = this.size;
  }

  private grow(): void {
    const columns = new Uint32Array(2 * this.size);
    const weights = new Float64Array(2 * this.size);
    columns.set(this.columns);
    weights.set(this.weights);
    this.columns = columns;
    this.weights = weights;
  }

  build(): SparseMatrix {
    const starts = this.starts.subarray(0, this.rows + 1);
    return { starts, columns: this.columns.slice(0, this.size), weights: this.weights.slice(0, this.size) };
  }
}

export const rowCount = ({ starts }: SparseMatrix): number => starts.length - 1;

/** out = M x for values of `width` numbers; writes `out` from value `first` on. `out` may be `x`, beyond what M reads. */
export function multiplySparseInto(
  m: SparseMatrix,
  x: Float64Array,
  width: number,
  out: Float64Array,
  first = 0,
): void {
  const { starts, columns, weights } = m;
  out.fill(0, first * width, (first + rowCount(m)) * width);
  for (let row = 0; row + 1 < starts.length; row++) {
    const at = (first + row) * width;
    for (let i = starts[row]; i < starts[row + 1]; i++) {
      const from = columns[i] * width;
      const w = weights[i];
      for (let k = 0; k < width; k++) out[at + k] += w * x[from + k];
    }
  }
}

export function multiplySparse(m: SparseMatrix, x: Float64Array, width: number): Float64Array {
  const out = new Float64Array(rowCount(m) * width);
  multiplySparseInto(m, x, width, out);
  return out;
}
