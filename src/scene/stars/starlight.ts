import { scale, type Vec3 } from '../../math/vec3.ts';
import { glowColor } from '../../spectrum/color/blackbodyColor.ts';
import { RGB_SHIFTS, type RgbColorMode } from '../../spectrum/doppler/rgbShifts.ts';
import type { RenderSettings } from '../view/view.ts';
import { blackbody } from './blackbody.ts';

/**
 * Radiance of a blackbody of T [K] shifted by D, in linear sRGB relative to its luminance at rest: that of a blackbody of T·D, Y(TD)/Y(T) times its colour. The
 * settings apply the fraction `dopplerMix` of the shift to the colour and `beaming` of D⁴ to the brightness. Modes without spectra shift the star's own colour.
 */
export function starlight(
  T: number,
  D: number,
  settings: Pick<RenderSettings, 'colors' | 'dopplerMix' | 'beaming'>,
): Vec3 {
  if (settings.colors !== 'spectral')
    return scale(rgbShift(settings.colors, glowColor(T), D, settings.dopplerMix), D ** (4 * settings.beaming));
  const shift = D ** settings.dopplerMix;
  const seen = blackbody(T * shift);
  const gain = (seen.luminance / (blackbody(T).luminance * shift ** 4)) * D ** (4 * settings.beaming);
  return [seen.color[0] * gain, seen.color[1] * gain, seen.color[2] * gain];
}

/** Unshifted light stays as it is in every mode. */
const rgbShift = (mode: RgbColorMode, rgb: Vec3, D: number, mix: number): Vec3 =>
  D === 1 ? rgb : RGB_SHIFTS[mode](rgb, D, mix);
