/** Numbers per texel of a table of lobes. */
export const CHANNELS = 4;

/**
 * Reads the channels of a table of lobes between its texels. Its columns are even in √(N·V), its rows run over a roughness; `row`: the place among these,
 * 0 … 1.
 */
export function lobeTexel(
  table: Float64Array,
  { columns, rows }: { readonly columns: number; readonly rows: number },
  NV: number,
  row: number,
): (channel: number) => number {
  const x = Math.sqrt(Math.min(Math.max(NV, 0), 1)) * (columns - 1);
  const y = row * (rows - 1);
  const [i, j] = [Math.min(Math.floor(x), columns - 2), Math.min(Math.floor(y), rows - 2)];
  const [s, t] = [x - i, y - j];
  return (channel) => {
    const value = (column: number, at: number): number => table[CHANNELS * (at * columns + column) + channel];
    return (
      (1 - t) * ((1 - s) * value(i, j) + s * value(i + 1, j)) +
      t * ((1 - s) * value(i, j + 1) + s * value(i + 1, j + 1))
    );
  };
}
