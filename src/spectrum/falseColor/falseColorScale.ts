import type { FalseColorQuantity, ValueRange } from './falseColor.ts';
import { SPECTRAL_BANDS } from './spectralBands.ts';

/** Samples of the shown quantity, spread over the picture; NaN where there is no value. */
type FalseColorValues = ArrayLike<number>;

/** Fraction of the values that may lie outside the scale at each end. */
const OUTLIER_FRACTION = 0.01;
/** Allowed upper ends of a scale of D; the lower end is the reciprocal. */
const SHIFTS = [1.02, 1.05, 1.1, 1.2, 1.5, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 1e4, 1e5, 1e6];
/** Most decades of a scale of light, counted from its upper end. */
const MAX_DECADES = 6;
/** Most significant digits of the numbers of a legend. */
const MAX_DIGITS = 6;
/** Range of emitted wavelengths that observers up to about 0.99 c see at 550 nm [m]. */
const WAVELENGTH_RANGE: ValueRange = { from: 3e-8, to: 1e-5 };

/** A scale with round ends that contains the values; that of bands is fixed. */
export function fitScale(kind: FalseColorQuantity, values: FalseColorValues): ValueRange {
  if (kind === 'band') return WAVELENGTH_RANGE;
  const known = Float64Array.from(values).filter(Number.isFinite).sort();
  const at = (share: number) => known[Math.round(share * (known.length - 1))] ?? (kind === 'emission-time' ? 0 : 1);
  return SCALES[kind](at(OUTLIER_FRACTION), at(1 - OUTLIER_FRACTION));
}

const SCALES = { doppler: shiftScale, 'emission-time': timeScale, radiance: lightScale } as const;

/** Centred at D = 1. */
function shiftScale(low: number, high: number): ValueRange {
  const most = Math.max(high, 1 / low);
  const to = SHIFTS.find((shift) => shift >= most) ?? SHIFTS.at(-1)!;
  return { from: 1 / to, to };
}

/** One end is 0, the observer's time, unless all values are far from it. */
function timeScale(low: number, high: number): ValueRange {
  const [first, last] = [low > 0 && low < 0.6 * high ? 0 : low, high < 0 && high > 0.6 * low ? 0 : high];
  const step = roundStep((last - first) / 4 || Math.abs(last) / 4 || 1);
  const [from, to] = [Math.floor(first / step + 1e-9) * step, Math.ceil(last / step - 1e-9) * step + 0];
  return to > from ? { from, to } : { from: from - step, to };
}

/** Both ends are powers of ten. */
function lightScale(low: number, high: number): ValueRange {
  const last = Math.ceil(Math.log10(Math.max(high, 1e-30)) - 1e-9);
  const first = Math.floor(Math.log10(Math.max(low, 1e-30)) + 1e-9);
  return { from: 10 ** Math.max(Math.min(first, last - 1), last - MAX_DECADES), to: 10 ** last };
}

/** The least of 1, 2, 5 times a power of ten that is not below x. */
function roundStep(x: number): number {
  const unit = 10 ** Math.floor(Math.log10(x) + 1e-9);
  return unit * ([1, 2, 5, 10].find((factor) => factor * unit >= x * (1 - 1e-9)) ?? 10);
}

/** The values at which a legend has numbers. */
export function ticksOf(kind: FalseColorQuantity, scale: ValueRange): number[] {
  switch (kind) {
    case 'doppler':
      return [scale.from, Math.sqrt(scale.from), 1, Math.sqrt(scale.to), scale.to];
    case 'emission-time':
      return steps(scale, roundStep((scale.to - scale.from) / 4));
    case 'radiance':
      return decades(scale);
    case 'band':
      return SPECTRAL_BANDS.map(({ from }) => from).filter((from) => from > scale.from && from < scale.to);
  }
}

function steps({ from, to }: ValueRange, step: number): number[] {
  const first = Math.ceil(from / step - 1e-9);
  const count = Math.floor(to / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, i) => (first + i) * step);
}

function decades({ from, to }: ValueRange): number[] {
  const [first, last] = [Math.round(Math.log10(from)), Math.round(Math.log10(to))];
  return Array.from({ length: last - first + 1 }, (_, i) => 10 ** (first + i));
}

/** The number of significant digits, from two up, at which all numbers of the legend read differently. */
export function tickDigits(ticks: readonly number[]): number {
  const alike = (digits: number): boolean => new Set(ticks.map((tick) => tick.toPrecision(digits))).size < ticks.length;
  let digits = 2;
  while (digits < MAX_DIGITS && alike(digits)) digits++;
  return digits;
}
