import { NANOMETRE, tristimulus } from '../observer/standardObserver.ts';
import { type MeasuredReflectance, measuredReflectanceAt } from '../reflectance/measuredReflectance.ts';
import { filterFromRgb, reflectanceAt, type SpectralFilter } from '../reflectance/spectralFilter.ts';
import { DAYLIGHT, spectralRadiance } from '../sources/lightSpectrum.ts';
import { toLinearSrgb } from './observerColor.ts';

/** Ranges over which the ultraviolet and the infrared reflectance are averaged [nm], as in the material presets. */
const ULTRAVIOLET = [300, 360] as const;
const INFRARED = [830, 1300] as const;

const known = new WeakMap<MeasuredReflectance, SpectralFilter>();

/**
 * The filter of a measured reflectance: its exact colour in daylight (negative channels, outside sRGB, set to 0) and its means over the near
 * ultraviolet and infrared. With its `residual` the filter equals the measured reflectance at every wavelength; the fast renderer uses the bands alone.
 * Cached per reflectance.
 */
export function filterOfReflectance(reflectance: MeasuredReflectance): SpectralFilter {
  const found = known.get(reflectance);
  if (found) return found;
  const seen = tristimulus(
    (wavelength) => measuredReflectanceAt(reflectance, wavelength) * spectralRadiance(DAYLIGHT, wavelength),
  );
  const [r, g, b] = toLinearSrgb(seen);
  const rgb = [Math.max(r, 0), Math.max(g, 0), Math.max(b, 0)] as const;
  const bands = filterFromRgb(rgb, mean(reflectance, ULTRAVIOLET), mean(reflectance, INFRARED));
  const at = (wavelength: number, width = 0): number =>
    measuredReflectanceAt(reflectance, wavelength) - reflectanceAt(bands, wavelength, width);
  const made = { ...bands, residual: { at, share: 1 } };
  known.set(reflectance, made);
  return made;
}

function mean(reflectance: MeasuredReflectance, [from, to]: readonly [number, number]): number {
  const all = Array.from({ length: to - from }, (_, i) =>
    measuredReflectanceAt(reflectance, (from + i + 0.5) * NANOMETRE),
  );
  return all.reduce((sum, value) => sum + value, 0) / all.length;
}
