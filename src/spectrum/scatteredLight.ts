import { dot, type Vec3 } from '../math/vec3.ts';
import { DAYLIGHT, type SampledSpectrum } from './lightSpectrum.ts';
import { whiteOf } from './observerColor.ts';
import { logPlanck } from './planck.ts';

/** What an eye sees shifted by 1/9 to 9. */
const [FIRST, LAST, STEP] = [40e-9, 7.5e-6, 5e-9];
const REFERENCE = 550e-9;

/** Daylight that air scatters: a blackbody of 6504 K times λ⁻⁴. Source: Rayleigh 1871, Phil. Mag. 41, 107. */
export const SCATTERED: SampledSpectrum = {
  kind: 'sampled',
  first: FIRST,
  step: STEP,
  values: Array.from({ length: Math.round((LAST - FIRST) / STEP) + 1 }, (_, i) => {
    const wavelength = FIRST + i * STEP;
    const daylight = logPlanck(wavelength, DAYLIGHT.temperature) - logPlanck(REFERENCE, DAYLIGHT.temperature);
    return Math.exp(daylight) * (wavelength / REFERENCE) ** -4;
  }),
};

/** Linear sRGB of scattered light of luminance 1, at rest. */
export const SCATTERED_COLOR: Vec3 = whiteOf(SCATTERED);

/**
 * What `scatteredShare` is linear in: of all w (1, 1, 1) + s `SCATTERED_COLOR` the nearest to a colour has s = `SCATTERED_PART` · colour
 * (least squares). Clear skies are such sums to 3 %: air and haze.
 */
export const SCATTERED_PART: Vec3 = partOf(SCATTERED_COLOR);

function partOf([r, g, b]: Vec3): Vec3 {
  const mean = (r + g + b) / 3;
  const apart: Vec3 = [r - mean, g - mean, b - mean];
  const scale = 1 / dot(apart, apart);
  return [apart[0] * scale, apart[1] * scale, apart[2] * scale];
}

/** How much of the light of a sky of linear sRGB `rgb` is scattered, as luminance; the rest is a filter before daylight. Nothing of a sky that is no bluer than white. */
export const scatteredShare = (rgb: Vec3): number => Math.max(dot(rgb, SCATTERED_PART), 0);
