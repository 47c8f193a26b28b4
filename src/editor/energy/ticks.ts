/** Label of an axis tick, with as few digits as represent it exactly. */
export function tick(value: number | null): string {
  if (value === null) return '';
  const round = Number(value.toPrecision(6));
  const size = Math.abs(round);
  const text = size !== 0 && (size >= 1e5 || size < 1e-3) ? round.toExponential() : String(round);
  return text.replace('e+', 'e').replaceAll('-', '−');
}

/** Width of the tick labels of an axis [px]. */
export const ticksWidth = (texts: readonly string[] | null): number =>
  17 + 7 * Math.max(2, ...(texts ?? []).map((text) => text.length));
