import { NANOMETRE, tristimulus } from '../observer/standardObserver.ts';
import { type MeasuredReflectance, measuredReflectanceAt } from '../reflectance/measuredReflectance.ts';
import { filterFromRgb, type SpectralFilter } from '../reflectance/spectralFilter.ts';
import { DAYLIGHT, spectralRadiance } from '../sources/lightSpectrum.ts';
import { toLinearSrgb } from './observerColor.ts';

/** What one number stands for, of ultraviolet and of infrared light [nm]: as in the presets of materials. */
const ULTRAVIOLET = [300, 360] as const;
const INFRARED = [830, 1300] as const;

const known = new WeakMap<MeasuredReflectance, SpectralFilter>();

/**
 * The bands of a measured reflectance: its colour in daylight (exactly; none below 0, where it lies outside of sRGB), and its means over the near ultraviolet and infrared. With `rest` they are the measured
 * reflectance itself at every wavelength; without, what the fast renderer shows of it.
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
  const made = { ...bands, residual: { base: { reflectance, bands }, share: 1 } };
  known.set(reflectance, made);
  return made;
}

function mean(reflectance: MeasuredReflectance, [from, to]: readonly [number, number]): number {
  const all = Array.from({ length: to - from }, (_, i) =>
    measuredReflectanceAt(reflectance, (from + i + 0.5) * NANOMETRE),
  );
  return all.reduce((sum, value) => sum + value, 0) / all.length;
}
