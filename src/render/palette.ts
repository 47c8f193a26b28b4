import type { Texture } from 'three/webgpu';
import { maybeDusky } from '../scene/daylight.ts';
import type { Scene } from '../scene/types.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { ColoredTables } from '../shaders/coloredTable.ts';
import { coloredTexture } from '../shaders/coloredTexture.ts';
import { observerTexture } from '../shaders/observerTexture.ts';
import { spectrumTexture } from '../shaders/spectrumTexture.ts';
import { thermalTable } from '../spectrum/thermalTable.ts';
import { DaylightTable } from './daylightTable.ts';
import { coloredLights, shineKind } from './lampShine.ts';
import type { Optics } from './radiance.ts';
import { type SpectralTables, spectral } from './spectral.ts';
import { plain, resting, tinted } from './tinted.ts';

/**
 * How passes are compiled to turn colours: by spectra, `physical` where all of the shift reaches colours and brightness, which needs no powers, and `resting` where
 * nothing is shifted and all light is daylight; or by a tint, `plain` where nothing is shifted.
 */
export type Palette = 'spectral' | 'physical' | 'resting' | 'approximate' | 'plain';

/** What the settings ask for. Where no shift is shown its code is left out, for on a software GPU it costs all the same. */
export function paletteOf({ view, colors, dopplerMix, beaming }: RenderSettings, scene: Scene): Palette {
  const shifted = view === 'light-cone' && (dopplerMix > 0 || beaming > 0);
  if (colors === 'approximate') return shifted ? 'approximate' : 'plain';
  if (shifted) return dopplerMix === 1 && beaming === 1 ? 'physical' : 'spectral';
  const { lights, materials } = scene;
  const daylight =
    lights.every((light) => light.kind === 'stars' || shineKind(light) === 'daylight') && !materials.some(isGlowing);
  return daylight ? 'resting' : 'spectral';
}

const isGlowing = ({ emissionTemperature }: Scene['materials'][number]): boolean => emissionTemperature !== undefined;

interface Tables extends Omit<SpectralTables, 'colored'> {
  readonly blackbodies: SpectralTables['blackbodies'] & { readonly texture: Texture };
}

/** The tables of spectral colours on the GPU, made when they are first asked for. */
export class Palettes {
  private readonly tables = new Map<3 | 4, Tables>();
  private readonly colored = new Map<string, ColoredTables & { readonly texture: Texture }>();
  private readonly observer = observerTexture();

  optics(palette: Palette, scene: Scene): Optics {
    const { materials } = scene;
    const glowing = materials.some(isGlowing);
    if (palette === 'approximate') return tinted(glowing);
    if (palette === 'plain' || palette === 'resting') return palette === 'plain' ? plain(glowing) : resting;
    const layers = materials.some(({ uv, ir }) => uv !== undefined || ir !== undefined) ? 4 : 3;
    const tables = this.tables.get(layers) ?? this.makeTables(layers);
    this.tables.set(layers, tables);
    return spectral(
      { ...tables, colored: () => this.coloredOf(scene, layers) },
      {
        glowing,
        dusky: maybeDusky(scene),
        whole: palette === 'physical',
      },
    );
  }

  /** Only shaders of scenes with coloured lights ask. */
  private coloredOf(scene: Scene, layers: 3 | 4): ColoredTables {
    const lights = coloredLights(scene);
    const key = `${layers} ${JSON.stringify(lights)}`;
    const tables = this.colored.get(key) ?? coloredTexture(lights, layers);
    this.colored.set(key, tables);
    return tables;
  }

  private makeTables(layers: 3 | 4): Tables {
    const table = thermalTable(layers);
    return { blackbodies: spectrumTexture(table), daylight: new DaylightTable(table), observer: this.observer };
  }

  dispose(): void {
    this.observer.texture.dispose();
    for (const { texture } of this.colored.values()) texture.dispose();
    for (const { blackbodies, daylight } of this.tables.values()) {
      blackbodies.texture.dispose();
      daylight.dispose();
    }
  }
}
