import { interpolateTable, NANOMETRE, VISIBLE } from '../observer/standardObserver.ts';
import { Y_BAR } from '../tables/cie1931.ts';
import type { Rgb8 } from './colorMaps.ts';

/**
 * Bands of the spectrum, each by its shortest wavelength [m], with its false colour: in rainbow order, continued beyond both ends, and
 * darker with distance from the visible, so that they differ without red–green vision too.
 */
export const SPECTRAL_BANDS = [
  { name: 'far-ultraviolet', from: 0, color: [88, 26, 140] },
  { name: 'near-ultraviolet', from: 200e-9, color: [124, 112, 255] },
  { name: 'visible', from: 380e-9, color: [148, 222, 124] },
  { name: 'near-infrared', from: 780e-9, color: [247, 148, 46] },
  { name: 'thermal-infrared', from: 3e-6, color: [186, 28, 52] },
] as const satisfies readonly { name: string; from: number; color: Rgb8 }[];
export type SpectralBandName = (typeof SPECTRAL_BANDS)[number]['name'];

/** Middle of the visible [m]: light observed at it was emitted at 550 nm · D. */
export const REFERENCE_WAVELENGTH = 550e-9;
/** The emitted wavelength of light observed at `REFERENCE_WAVELENGTH` [m]. */
export const emittedWavelength = (D: number): number => REFERENCE_WAVELENGTH * D;

/** The band of a wavelength [m]. */
export const bandOf = (wavelength: number): SpectralBandName =>
  SPECTRAL_BANDS.findLast(({ from }) => wavelength >= from)?.name ?? 'far-ultraviolet';

/** ∫ ȳ dλ from the violet end to the end of each nanometre, as a fraction of the whole. */
const LUMINOUS = runningShare(Y_BAR);

function runningShare(values: readonly number[]): number[] {
  const sums = [0];
  for (const value of values) sums.push(sums.at(-1)! + value);
  return sums.map((sum) => sum / sums.at(-1)!);
}

/** The fraction of ∫ ȳ dλ at wavelengths below λ [m]. */
function luminousBelow(wavelength: number): number {
  const place = (Math.min(wavelength, VISIBLE[1]) - VISIBLE[0]) / NANOMETRE;
  return interpolateTable(LUMINOUS, Math.max(place, 0));
}

/**
 * The fraction of the observed luminance that was emitted in each band, for light shifted by D: ∫ ȳ(λ) over those λ whose Dλ is in the
 * band, ÷ ∫ ȳ dλ. Exact for an equal-energy spectrum; others differ little, because luminance comes mostly from 500 … 620 nm. docs/physics.md §8.3.
 */
export const bandShares = (D: number): number[] =>
  SPECTRAL_BANDS.map(
    ({ from }, i) =>
      luminousBelow((SPECTRAL_BANDS[i + 1]?.from ?? Number.POSITIVE_INFINITY) / D) - luminousBelow(from / D),
  );

/** The mean of the bands' colours, weighted by `bandShares`. */
export function bandColor(D: number): Rgb8 {
  const sum: [number, number, number] = [0, 0, 0];
  bandShares(D).forEach((share, i) => {
    for (let k = 0; k < 3; k++) sum[k]! += share * SPECTRAL_BANDS[i]!.color[k]!;
  });
  return [Math.round(sum[0]), Math.round(sum[1]), Math.round(sum[2])];
}
