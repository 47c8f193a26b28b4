import { scale, type Vec3 } from '../math/vec3.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { Bands } from '../spectrum/bands.ts';
import { dopplerTint } from '../spectrum/dopplerTint.ts';
import { DARK, type Light } from './light.ts';
import type { Eye, Sight } from './sight.ts';

/** The approximate mode: light is linear sRGB everywhere, filters are multiplied channel by channel, and a shift is a tint (dopplerTint.ts). */
export function tintedEye({ dopplerMix, beaming }: Pick<RenderSettings, 'dopplerMix' | 'beaming'>): Eye {
  const sight: Sight = {
    shining: ({ color }) => lightOf(color),
    filtered: (light: Light, { rgb: [r, g, b] }: Bands) => {
      const [x, y, z] = colorOf(light);
      return lightOf([r * x, g * y, b * z]);
    },
    through: () => sight,
    arrived: (light, D, power) =>
      D === 1 ? light : lightOf(scale(dopplerTint(colorOf(light), D, dopplerMix), D ** (power * beaming))),
  };
  return { sight, color: colorOf };
}

const lightOf = (values: Vec3): Light => ({ values, lines: DARK.lines });
const colorOf = ({ values: [r = 0, g = 0, b = 0] }: Light): Vec3 => [r, g, b];
