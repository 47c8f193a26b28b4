import { add, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { MIN_SHIFT, RGB_SHIFTS, type RgbColorMode, SHIFTS_EACH_LIGHT } from '../../spectrum/doppler/rgbShifts.ts';
import type { SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { eachColor, NO_LIGHT, type SampledRadiance } from './sampledRadiance.ts';
import type { Sensor, SpectralContext } from './spectralContext.ts';

/** Modes without spectra: light is linear sRGB everywhere, filters multiply each channel, and so do Doppler shifts (rgbShifts.ts). docs/physics.md §7.10. */
export function rgbSensor(
  colors: RgbColorMode,
  { dopplerMix, beaming }: Pick<RenderSettings, 'dopplerMix' | 'beaming'>,
): Sensor {
  const shift = RGB_SHIFTS[colors];
  const single = SHIFTS_EACH_LIGHT.includes(colors);
  // A shift by cases is no identity at D = 1, and leaves what has not moved as it is.
  const least = single ? MIN_SHIFT : 0;
  const lightOf = (color: Vec3): SampledRadiance =>
    single ? { ...NO_LIGHT, colors: [color] } : { values: color, lines: NO_LIGHT.lines };
  const changed = (light: SampledRadiance, change: (color: Vec3) => Vec3): SampledRadiance =>
    single ? eachColor(light, change) : lightOf(change(colorOf(light)));
  const context: SpectralContext = {
    emitted: ({ color }) => lightOf(color),
    together: (light) => (single ? lightOf(colorOf(light)) : light),
    filtered: (light, { rgb }: SpectralFilter) =>
      changed(light, (color) => [color[0] * rgb[0], color[1] * rgb[1], color[2] * rgb[2]]),
    absorbed: (light, { rgb }, x) =>
      changed(light, (color) => [color[0] * rgb[0] ** x, color[1] * rgb[1] ** x, color[2] * rgb[2] ** x]),
    samples: single ? [] : PRIMARIES,
    shifted: () => context,
    received: (light, D, power) =>
      Math.abs(D - 1) <= least
        ? light
        : changed(light, (color) => scale(shift(color, D, dopplerMix), D ** (power * beaming))),
  };
  return { context, color: colorOf };
}

/** Wavelengths of the primaries of sRGB [m]. */
export const PRIMARIES = [611e-9, 549e-9, 464e-9];

const colorOf = ({ values: [r = 0, g = 0, b = 0], colors }: SampledRadiance): Vec3 =>
  colors ? colors.reduce(add, ZERO) : [r, g, b];
