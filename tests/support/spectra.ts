import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import type { Vec3 } from '../../src/math/vec3.ts';
import type { SpectralFilter } from '../../src/spectrum/reflectance/spectralFilter.ts';
import type { ThermalSpectrum } from '../../src/spectrum/sources/lightSpectrum.ts';

/** [r, g, b, uv, ir] */
type Five = readonly [number, number, number, number, number];

/** Values of colour-science (src/spectrum/fixtures/oracle.py). */
interface Judged {
  /** At 360, 370 … 830 nm. */
  readonly matching: readonly Vec3[];
  /** As printed, at 380, 400 … 780 nm. */
  readonly basis: readonly Vec3[];
  /** T [K], nm, B relative to that at 560 nm. */
  readonly planck: readonly Vec3[];
  /** T [K] and x, y. */
  readonly blackbodies: readonly (readonly [number, readonly [number, number]])[];
  readonly normaliser: readonly Vec3[];
  readonly srgb: readonly Vec3[];
  readonly p3: readonly Vec3[];
  readonly daylight: readonly (readonly [number, readonly number[]])[];
  readonly lamps: Readonly<Record<string, { readonly values: readonly number[]; readonly xy: readonly number[] }>>;
  /** Two colours in L*a*b*, and ΔE₀₀ between them. */
  readonly differences: readonly (readonly [Vec3, Vec3, number])[];
  readonly seen: readonly JudgedColor[];
}

interface JudgedColor {
  readonly a: Five;
  readonly k: Five;
  readonly T: number;
  readonly Din: number;
  readonly Dout: number;
  /** Relative to the luminance of a blackbody of T·D, with the filter k (`rgb`) and without (`neutral`). */
  readonly rgb: Vec3;
  readonly neutral: Vec3;
}

const url = new URL('../../src/spectrum/fixtures/oracle.expected.json', import.meta.url);
export const judged: Judged = JSON.parse(readFileSync(url, 'utf8'));

export const fromFive = ([r, g, b, uv, ir]: Five): SpectralFilter => ({ rgb: [r, g, b], uv, ir });

export const thermal = (temperature: number): ThermalSpectrum => ({ kind: 'thermal', temperature });

const fraction = fc.double({ min: 0, max: 1, noNaN: true });
/** Any reflectance. */
export const anyBands: fc.Arbitrary<SpectralFilter> = fc.record({
  rgb: fc.tuple(fraction, fraction, fraction),
  uv: fraction,
  ir: fraction,
});
/** Log-uniform between two numbers. */
export const logarithmic = (min: number, max: number): fc.Arbitrary<number> =>
  fc.double({ min: Math.log(min), max: Math.log(max), noNaN: true }).map(Math.exp);
/** A Doppler factor between 1/8 and 8. */
export const anyShift = logarithmic(1 / 8, 8);
