import { interpolateTable, NANOMETRE, VISIBLE } from '../observer/standardObserver.ts';
import { Y_BAR } from '../tables/cie1931.ts';
import type { Rgb8 } from './colorMaps.ts';

/**
 * Parts of the spectrum, each from its shortest wavelength on [m], with the colour that tells it: in the order of the rainbow, beyond both of its
 * ends, and the darker the farther from the visible, so that they can be told apart without seeing red or green.
 */
export const SPECTRAL_BANDS = [
  { name: 'far-ultraviolet', from: 0, color: [88, 26, 140] },
  { name: 'near-ultraviolet', from: 200e-9, color: [124, 112, 255] },
  { name: 'visible', from: 380e-9, color: [148, 222, 124] },
  { name: 'near-infrared', from: 780e-9, color: [247, 148, 46] },
  { name: 'thermal-infrared', from: 3e-6, color: [186, 28, 52] },
] as const satisfies readonly { name: string; from: number; color: Rgb8 }[];
export type SpectralBandName = (typeof SPECTRAL_BANDS)[number]['name'];

/** Of the middle of the visible [m]: light that is seen at it was emitted at 550 nm · D. */
export const REFERENCE_WAVELENGTH = 550e-9;
/** The wavelength at which what is seen as the middle of the visible was emitted [m]. */
export const emittedWavelength = (D: number): number => REFERENCE_WAVELENGTH * D;

/** The band of a wavelength [m]. */
export const bandOf = (wavelength: number): SpectralBandName =>
  SPECTRAL_BANDS.findLast(({ from }) => wavelength >= from)?.name ?? 'far-ultraviolet';

/** ∫ ȳ dλ from the violet end on, up to the end of each nanometre, as a share of the whole. */
const LUMINOUS = runningShare(Y_BAR);

function runningShare(values: readonly number[]): number[] {
  const sums = [0];
  for (const value of values) sums.push(sums.at(-1)! + value);
  return sums.map((sum) => sum / sums.at(-1)!);
}

/** The share of ȳ at wavelengths below λ [m]. */
function luminousBelow(wavelength: number): number {
  const place = (Math.min(wavelength, VISIBLE[1]) - VISIBLE[0]) / NANOMETRE;
  return interpolateTable(LUMINOUS, Math.max(place, 0));
}

/**
 * How much of the brightness that an eye sees was emitted in each of the bands, where light is shifted by D: ∫ ȳ(λ) over those λ whose Dλ is in the
 * band, ÷ ∫ ȳ dλ. Exact for light of equal energy at all wavelengths; as an eye's brightness comes from 500 … 620 nm, others differ little.
 */
export const bandShares = (D: number): number[] =>
  SPECTRAL_BANDS.map(
    ({ from }, i) =>
      luminousBelow((SPECTRAL_BANDS[i + 1]?.from ?? Number.POSITIVE_INFINITY) / D) - luminousBelow(from / D),
  );

/** The mean of the bands' colours, each by its share. */
export function bandColor(D: number): Rgb8 {
  const sum: [number, number, number] = [0, 0, 0];
  bandShares(D).forEach((share, i) => {
    for (let k = 0; k < 3; k++) sum[k]! += share * SPECTRAL_BANDS[i]!.color[k]!;
  });
  return [Math.round(sum[0]), Math.round(sum[1]), Math.round(sum[2])];
}
