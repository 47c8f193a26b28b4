import { scale, type Vec3 } from '../../math/vec3.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { RGB_SHIFTS, type RgbColorMode } from '../../spectrum/doppler/rgbShifts.ts';
import type { SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { NO_LIGHT, type SampledRadiance } from './sampledRadiance.ts';
import type { Sensor, SpectralContext } from './spectralContext.ts';

/** Modes without spectra: light is linear sRGB everywhere, filters multiply each channel, and so do Doppler shifts (rgbShifts.ts). docs/physics.md §7.10. */
export function rgbSensor(
  colors: RgbColorMode,
  { dopplerMix, beaming }: Pick<RenderSettings, 'dopplerMix' | 'beaming'>,
): Sensor {
  const shift = RGB_SHIFTS[colors];
  const context: SpectralContext = {
    emitted: ({ color }) => lightOf(color),
    filtered: (light: SampledRadiance, { rgb: [r, g, b] }: SpectralFilter) => {
      const [x, y, z] = colorOf(light);
      return lightOf([r * x, g * y, b * z]);
    },
    shifted: () => context,
    received: (light, D, power) =>
      D === 1 ? light : lightOf(scale(shift(colorOf(light), D, dopplerMix), D ** (power * beaming))),
  };
  return { context, color: colorOf };
}

const lightOf = (values: Vec3): SampledRadiance => ({ values, lines: NO_LIGHT.lines });
const colorOf = ({ values: [r = 0, g = 0, b = 0] }: SampledRadiance): Vec3 => [r, g, b];
