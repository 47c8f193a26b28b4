import { scale, type Vec3 } from '../../math/vec3.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { dopplerTint } from '../../spectrum/doppler/dopplerTint.ts';
import type { SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { NO_LIGHT, type SampledRadiance } from './sampledRadiance.ts';
import type { Sensor, SpectralContext } from './spectralContext.ts';

/** The approximate mode: light is linear sRGB everywhere, filters are multiplied channel by channel, and a shift is a tint (dopplerTint.ts). */
export function rgbSensor({ dopplerMix, beaming }: Pick<RenderSettings, 'dopplerMix' | 'beaming'>): Sensor {
  const sight: SpectralContext = {
    emitted: ({ color }) => lightOf(color),
    filtered: (light: SampledRadiance, { rgb: [r, g, b] }: SpectralFilter) => {
      const [x, y, z] = colorOf(light);
      return lightOf([r * x, g * y, b * z]);
    },
    shifted: () => sight,
    received: (light, D, power) =>
      D === 1 ? light : lightOf(scale(dopplerTint(colorOf(light), D, dopplerMix), D ** (power * beaming))),
  };
  return { context: sight, color: colorOf };
}

const lightOf = (values: Vec3): SampledRadiance => ({ values, lines: NO_LIGHT.lines });
const colorOf = ({ values: [r = 0, g = 0, b = 0] }: SampledRadiance): Vec3 => [r, g, b];
