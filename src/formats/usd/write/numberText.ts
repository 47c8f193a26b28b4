/** The shortest text that reads back as the same double. */
export function doubleText(x: number): string {
  if (Number.isNaN(x)) return 'nan';
  if (!Number.isFinite(x)) return x > 0 ? 'inf' : '-inf';
  return Object.is(x, -0) ? '-0' : String(x);
}

/** A short text that reads back as the same f32. */
export function floatText(value: number): string {
  const x = Math.fround(value);
  if (Number.isInteger(x) || !Number.isFinite(x)) return doubleText(x);
  for (let digits = 6; digits < 9; digits++) {
    const short = Number(x.toPrecision(digits));
    if (Math.fround(short) === x) return String(short);
  }
  return String(Number(x.toPrecision(9)));
}
