import type { Vec3 } from '../../math/vec3.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import { logLuminance } from '../../spectrum/sources/planck.ts';
import type { RenderSettings } from '../view/view.ts';
import { blackbody } from './blackbody.ts';

/** The cosmic microwave background at rest in it [K]. Source: Fixsen 2009, ApJ 707, 916. */
export const COSMIC_TEMPERATURE = 2.7255;

/** 2hc² [W m²/sr] times the 683 lm/W of the visible (CODATA 2018, exact in the SI). */
const RADIATION = 683 * 2 * 6.62607015e-34 * SPEED_OF_LIGHT ** 2;

/** Luminance of a blackbody of 6504 K [cd/m²]. */
export const DAYLIGHT_LUMINANCE = RADIATION * Math.exp(logLuminance(DAYLIGHT.temperature));

/**
 * The background seen with Doppler factor D: linear sRGB whose luminance is in cd/m². Black unless D is in the
 * hundreds; then a ring, red, then white, opens ahead. Scaled by the settings' shares of the shift.
 */
export function cosmicBackground(
  D: number,
  { dopplerMix, beaming }: Pick<RenderSettings, 'dopplerMix' | 'beaming'>,
): Vec3 {
  const shift = D ** dopplerMix;
  const { color, luminance } = blackbody(COSMIC_TEMPERATURE * shift);
  const gain = (DAYLIGHT_LUMINANCE * luminance * D ** (4 * beaming)) / shift ** 4;
  return [gain * color[0], gain * color[1], gain * color[2]];
}
