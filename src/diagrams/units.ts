/** A unit of an axis, and its size in SI. */
export interface AxisUnit {
  readonly name: string;
  readonly size: number;
}

const YEAR = 31_557_600; // [s], Julian

const LENGTHS: readonly AxisUnit[] = [
  { name: 'nm', size: 1e-9 },
  { name: 'µm', size: 1e-6 },
  { name: 'mm', size: 1e-3 },
  { name: 'm', size: 1 },
  { name: 'km', size: 1e3 },
  { name: 'Mm', size: 1e6 },
  { name: 'Gm', size: 1e9 },
  { name: 'Tm', size: 1e12 },
  { name: 'ly', size: 299_792_458 * YEAR },
];
const TIMES: readonly AxisUnit[] = [
  { name: 'fs', size: 1e-15 },
  { name: 'ps', size: 1e-12 },
  { name: 'ns', size: 1e-9 },
  { name: 'µs', size: 1e-6 },
  { name: 'ms', size: 1e-3 },
  { name: 's', size: 1 },
  { name: 'min', size: 60 },
  { name: 'h', size: 3600 },
  { name: 'd', size: 86_400 },
  { name: 'a', size: YEAR },
];

/** The largest unit of which there is at least one; the smallest one of less. */
const fitting = (units: readonly AxisUnit[], value: number): AxisUnit =>
  units.findLast(({ size }) => value >= 0.999999 * size) ?? units[0]!;

/** For an axis to ± a length [m]. */
export const lengthUnit = (length: number): AxisUnit => fitting(LENGTHS, length);
/** For a time [s]. */
export const timeUnit = (time: number): AxisUnit => fitting(TIMES, time);

/** A number with as few digits as show it, and a true minus sign. */
export const plainNumber = (value: number): string =>
  String(Number(value.toPrecision(6)))
    .replace('e+', 'e')
    .replaceAll('-', '−');

/** β of |u| = γβ, near 1 by what is missing: `0.6`, `1 − 5e−7`. */
export function betaText(u: number): string {
  const beta = u / Math.hypot(1, u);
  const missing = 1 / ((1 + beta) * (1 + u * u));
  return missing < 1e-4 ? `1 − ${plainNumber(Number(missing.toPrecision(2)))}` : String(Number(beta.toFixed(5)));
}
