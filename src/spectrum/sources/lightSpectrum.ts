import { colorMatching, interpolateTable, NANOMETRE, tristimulus } from '../observer/standardObserver.ts';
import { logLuminance, logPlanck, SECOND_RADIATION } from './planck.ts';

/** A blackbody of a temperature above 0 [K]; shifted by D, one of T·D. */
export interface ThermalSpectrum {
  readonly kind: 'thermal';
  /** [K], above 0. */
  readonly temperature: number;
}

/** A line at a wavelength [m] of relative radiance `weight`. */
export interface SpectralLine {
  /** In its source's rest frame [m]. */
  readonly wavelength: number;
  /** Relative radiance. */
  readonly weight: number;
}

/** Light of single wavelengths: vapour lamps, nebulae, lasers. */
export interface LineSpectrum {
  readonly kind: 'lines';
  /** At least one. */
  readonly lines: readonly SpectralLine[];
}

/** Relative radiance per wavelength at `first`, `first + step` … [m], at least two values, linear between them, 0 outside. */
export interface SampledSpectrum {
  readonly kind: 'sampled';
  /** Wavelength of the first value [m]. */
  readonly first: number;
  /** From value to value [m]. */
  readonly step: number;
  /** Relative radiance per wavelength. */
  readonly values: readonly number[];
}

/** The relative spectrum of light in its source's rest frame; brightness is given by the source. */
export type LightSpectrum = ThermalSpectrum | LineSpectrum | SampledSpectrum;

/**
 * The default spectrum of lights: a blackbody of 6504 K, whose colour is nearly the white of sRGB.
 * @example
 * DAYLIGHT.temperature; // 6504 K
 */
export const DAYLIGHT: ThermalSpectrum = { kind: 'thermal', temperature: 6504 };

/**
 * S(λ) [1/m] of a spectrum at a wavelength [m] in its source's rest frame, scaled so that its luminance ∫ ȳ S dλ is 1.
 * For lines see `linesOf`. A spectrum that is invisible at rest is scaled as if all of its power were at 555 nm.
 * @example
 * // Wien: a blackbody of 5796 K is brightest at 500 nm.
 * const sun = { kind: 'thermal', temperature: 5796 } as const;
 * const at = (nm: number) => spectralRadiance(sun, nm * 1e-9);
 * at(500) > at(490) && at(500) > at(510); // true
 */
export function spectralRadiance(spectrum: ThermalSpectrum | SampledSpectrum, wavelength: number): number {
  if (spectrum.kind === 'thermal') return thermalRadiance(spectrum.temperature, wavelength, scaleOf(spectrum));
  return interpolateTable(spectrum.values, (wavelength - spectrum.first) / spectrum.step) * scaleOf(spectrum);
}

/** The mean of S(λ) over a step of `width` [m] around a wavelength, so that narrow features are not missed; for a blackbody S(λ) itself. */
export function meanRadiance(spectrum: ThermalSpectrum | SampledSpectrum, wavelength: number, width: number): number {
  if (spectrum.kind === 'thermal') return spectralRadiance(spectrum, wavelength);
  return meanSample(spectrum, wavelength, width) * scaleOf(spectrum);
}

/**
 * `meanRadiance` over adjoining steps of `width` [m], the first of them around `wavelength` [m]: as many as `out` has. Each limit is
 * evaluated once, for the tables.
 */
export function meanRadiances(spectrum: SampledSpectrum, wavelength: number, width: number, out: Float64Array): void {
  const sums = sumsOf(spectrum);
  const share = width / spectrum.step;
  const start = (wavelength - spectrum.first) / spectrum.step - share / 2;
  const factor = scaleOf(spectrum) / share;
  let before = integralUpTo(spectrum.values, sums, start);
  for (let n = 0; n < out.length; n++) {
    const after = integralUpTo(spectrum.values, sums, start + (n + 1) * share);
    out[n] = (after - before) * factor;
    before = after;
  }
}

function meanSample(spectrum: SampledSpectrum, wavelength: number, width: number): number {
  const { values } = spectrum;
  const sums = sumsOf(spectrum);
  const place = (wavelength - spectrum.first) / spectrum.step;
  const half = width / (2 * spectrum.step);
  return (integralUpTo(values, sums, place + half) - integralUpTo(values, sums, place - half)) / (2 * half);
}

/** ∫ of the values from the first to each, in units of the step. */
const sumsOf = (spectrum: SampledSpectrum): Float64Array =>
  memoize(integrals, spectrum, () => runningIntegral(spectrum.values));

/** ∫ of the values from the first to `place`, in units of the step; `sums`: `sumsOf`. */
function integralUpTo(values: readonly number[], sums: Float64Array, place: number): number {
  const within = Math.min(Math.max(place, 0), values.length - 1);
  const i = Math.min(Math.floor(within), values.length - 2);
  const t = within - i;
  return sums[i] + t * (values[i] + ((values[i + 1] - values[i]) * t) / 2);
}

function runningIntegral(values: readonly number[]): Float64Array {
  const sums = new Float64Array(values.length);
  for (let i = 1; i < values.length; i++) sums[i] = sums[i - 1] + (values[i - 1] + values[i]) / 2;
  return sums;
}

/**
 * The lines of a spectrum, scaled so that their luminance Σ w ȳ(λ) is 1; spectra invisible at rest as in `spectralRadiance`.
 * @example
 * // All of the light at the green where the eye is most sensitive: ȳ is 1 there.
 * linesOf({ kind: 'lines', lines: [{ wavelength: 555e-9, weight: 7 }] }); // [{ wavelength: 555.0e-9, weight: 1.00 }]
 */
export function linesOf(spectrum: LineSpectrum): readonly SpectralLine[] {
  const scale = scaleOf(spectrum);
  return spectrum.lines.map(({ wavelength, weight }) => ({ wavelength, weight: weight * scale }));
}

/** Limit of ln B/Y: light of 1 K scaled to the luminance of daylight would overflow when blue-shifted. */
const MAX_LOG = 600;

/** Exponents below which Planck's law is evaluated directly, three times as fast as by logarithms. */
const MAX_PLAIN_EXPONENT = 200;

/** B(λ, T)/Y(T) [1/m], for ln Y(T). */
function thermalRadiance(T: number, wavelength: number, logY: number): number {
  const x = SECOND_RADIATION / (wavelength * T);
  const fifth = wavelength * wavelength * wavelength * wavelength * wavelength;
  if (x < MAX_PLAIN_EXPONENT && Math.abs(logY) < MAX_PLAIN_EXPONENT && fifth > 1e-100)
    return Math.exp(-logY) / (fifth * Math.expm1(x));
  return Math.exp(Math.min(logPlanck(wavelength, T) - logY, MAX_LOG));
}

/** Caches of ln Y (blackbodies), 1/Y (others) and running integrals, which a path tracer needs for every ray. */
const scales = new WeakMap<LightSpectrum, number>();
const integrals = new WeakMap<LightSpectrum, Float64Array>();

function memoize<T>(kept: WeakMap<LightSpectrum, T>, spectrum: LightSpectrum, find: () => T): T {
  const known = kept.get(spectrum);
  if (known !== undefined) return known;
  const found = find();
  kept.set(spectrum, found);
  return found;
}

const scaleOf = (spectrum: LightSpectrum): number => memoize(scales, spectrum, () => findScale(spectrum));

function findScale(spectrum: LightSpectrum): number {
  if (spectrum.kind === 'thermal') return logLuminance(spectrum.temperature);
  const [luminance, power] = spectrum.kind === 'lines' ? ofLines(spectrum) : ofSamples(spectrum);
  if (luminance > 1e-6 * power) return 1 / luminance;
  // ȳ = 1 at 555 nm.
  return power > 0 ? 1 / power : 0;
}

function ofLines({ lines }: LineSpectrum): [luminance: number, power: number] {
  const total = (value: (line: SpectralLine) => number) => lines.reduce((sum, line) => sum + value(line), 0);
  return [total(({ wavelength, weight }) => weight * colorMatching(wavelength)[1]), total(({ weight }) => weight)];
}

function ofSamples(spectrum: SampledSpectrum): [luminance: number, power: number] {
  const { values, step } = spectrum;
  const [, Y] = tristimulus((wavelength) => meanSample(spectrum, wavelength, NANOMETRE));
  return [Y, integralUpTo(values, sumsOf(spectrum), values.length) * step];
}
