/** Arithmetic of numbers, or of nodes of a shader. */
interface Arithmetic<T> {
  readonly add: (a: T, b: T) => T;
  readonly multiply: (a: T, b: T) => T;
  readonly negate: (a: T) => T;
  readonly divide: (a: T, b: T) => T;
}

/** Elements of the inverse of a square matrix, column after column, by cofactors: adj M/det M. */
export function inverseOf<T>(
  size: number,
  element: (i: number) => T,
  { add, multiply, negate, divide }: Arithmetic<T>,
): T[] {
  const all = Array.from({ length: size }, (_, k) => k);
  const at = (row: number, column: number): T => element(column * size + row);
  const without = (list: readonly number[], k: number): readonly number[] => list.filter((x) => x !== k);
  const determinant = (rows: readonly number[], columns: readonly number[]): T => {
    const [row = 0, ...others] = rows;
    if (others.length === 0) return at(row, columns[0] ?? 0);
    const terms = columns.map((column, k) => {
      const term = multiply(at(row, column), determinant(others, without(columns, column)));
      return k % 2 === 0 ? term : negate(term);
    });
    return terms.reduce(add);
  };
  const cofactor = (row: number, column: number): T => {
    const minor = determinant(without(all, row), without(all, column));
    return (row + column) % 2 === 0 ? minor : negate(minor);
  };
  const cofactors = all.map((row) => all.map((column) => cofactor(row, column)));
  const whole = all.map((column) => multiply(at(0, column), cofactors[0]?.[column] as T)).reduce(add);
  return all.flatMap((column) => all.map((row) => divide(cofactors[column]?.[row] as T, whole)));
}
