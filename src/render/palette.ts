import type { Texture } from 'three/webgpu';
import type { Scene } from '../scene/types.ts';
import type { ColorMode, RenderSettings } from '../scene/view.ts';
import { observerTexture } from '../shaders/observerTexture.ts';
import type { SpectrumTable } from '../shaders/spectrumTable.ts';
import { spectrumTexture } from '../shaders/spectrumTexture.ts';
import { thermalTable } from '../spectrum/thermalTable.ts';
import { shineKind } from './lampShine.ts';
import type { Optics } from './radiance.ts';
import { spectral } from './spectral.ts';
import { plain, tinted } from './tinted.ts';

/** How passes are compiled to turn colours; `plain`: nothing is shifted, and all light is daylight. */
export type Palette = ColorMode | 'plain';

/** What the settings ask for. Where no shift is shown its code is left out, for on a software GPU it costs all the same. */
export function paletteOf(
  { view, colors, dopplerMix, beaming }: RenderSettings,
  { lights, materials }: Scene,
): Palette {
  const shifted = view === 'light-cone' && (dopplerMix > 0 || beaming > 0);
  const daylight = lights.every((light) => shineKind(light) === 'daylight') && !materials.some(isGlowing);
  return shifted || (colors === 'spectral' && !daylight) ? colors : 'plain';
}

const isGlowing = ({ emissionTemperature }: Scene['materials'][number]): boolean => emissionTemperature !== undefined;

/** The tables of spectral colours on the GPU, made when they are first asked for. */
export class Palettes {
  private readonly tables = new Map<3 | 4, SpectrumTable & { readonly texture: Texture }>();
  private readonly observer = observerTexture();

  optics(palette: Palette, { materials }: Scene): Optics {
    if (palette !== 'spectral') return palette === 'plain' ? plain : tinted;
    const layers = materials.some(({ uv, ir }) => uv !== undefined || ir !== undefined) ? 4 : 3;
    const table = this.tables.get(layers) ?? spectrumTexture(thermalTable(layers));
    this.tables.set(layers, table);
    return spectral(table, this.observer, materials.some(isGlowing));
  }

  dispose(): void {
    for (const { texture } of [this.observer, ...this.tables.values()]) texture.dispose();
  }
}
