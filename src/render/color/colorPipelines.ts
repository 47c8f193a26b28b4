import { directLights, hasDomeLight, sceneDome } from '../../scene/lights/sceneLights.ts';
import type { Scene } from '../../scene/types.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { VIEWS } from '../../scene/views/views.ts';
import type { HalfAtlas } from '../../shaders/tables/halfAtlas.ts';
import { observerTexels } from '../../shaders/tables/observerTable.ts';
import { spectrumTable } from '../../shaders/tables/spectrumTable.ts';
import type { DopplerTable } from '../../spectrum/doppler/dopplerTable.ts';
import { type FilteredBlackbody, filteredBlackbodyTable } from '../../spectrum/doppler/filterPairs.ts';
import { thermalTable } from '../../spectrum/doppler/thermalTable.ts';
import { DaylightColumns, DaylightTable } from './daylightTable.ts';
import { coloredLights, domeSpectrumKind, spectrumKindOf } from './lightSpectra.ts';
import type { ColorPipeline } from './radiance.ts';
import { type SpectralTables, spectralPipeline } from './spectralPipeline.ts';
import { restPipeline, tintPipeline, unshiftedPipeline } from './srgbPipelines.ts';

/**
 * How passes are compiled to turn colours: by spectra, `physical` where all of the shift reaches colours and brightness, which needs no powers, and `resting` where
 * nothing is shifted and all light is daylight; or by a tint, `plain` where nothing is shifted.
 */
export type ColorVariant = 'spectral' | 'physical' | 'resting' | 'approximate' | 'plain';

/** What the settings ask for. Where no shift is shown its code is left out, for on a software GPU it costs all the same. */
export function colorVariantOf({ view, colors, dopplerMix, beaming }: RenderSettings, scene: Scene): ColorVariant {
  const shifted = VIEWS[view].luminous && (dopplerMix > 0 || beaming > 0);
  if (colors === 'approximate') return shifted ? 'approximate' : 'plain';
  if (shifted) return dopplerMix === 1 && beaming === 1 ? 'physical' : 'spectral';
  const daylight =
    domeSpectrumKind(sceneDome(scene)) === 'daylight' &&
    directLights(scene).every((light) => spectrumKindOf(light) === 'daylight') &&
    !scene.materials.some(isGlowing);
  return daylight ? 'resting' : 'spectral';
}

const isGlowing = ({ emissionTemperature }: Scene['materials'][number]): boolean => emissionTemperature !== undefined;

/** Of coloured lights, of this scene and of earlier ones. */
const MAX_CACHED_TABLES = 60;

/** What spectral colours are looked up in, made when it is first asked for. Scenes share it, but each has its own copy on the GPU. */
export class ColorPipelines {
  private readonly blackbodies = new Map<3 | 4, { readonly table: DopplerTable; readonly daylight: DaylightColumns }>();
  private readonly colored = new Map<string, DopplerTable>();

  /** `atlas`: the scene's. */
  pipeline(palette: ColorVariant, scene: Scene, atlas: HalfAtlas): ColorPipeline {
    const { materials } = scene;
    const glowing = materials.some(isGlowing);
    if (palette === 'approximate') return tintPipeline(glowing);
    if (palette === 'plain' || palette === 'resting')
      return palette === 'plain' ? unshiftedPipeline(glowing) : restPipeline(hasDomeLight(scene));
    const layers = materials.some(({ uv, ir }) => uv !== undefined || ir !== undefined) ? 4 : 3;
    return spectralPipeline(this.tables(scene, layers, atlas), {
      glowing,
      reddenedSky: hasDomeLight(scene),
      fullShift: palette === 'physical',
    });
  }

  private tables(scene: Scene, layers: 3 | 4, atlas: HalfAtlas): SpectralTables {
    const { table, daylight } = this.blackbodiesOf(layers);
    const lights = coloredLights(scene);
    return {
      blackbodies: spectrumTable(atlas, 'blackbodies', table),
      daylight: new DaylightTable(daylight, atlas),
      lights,
      colored: (light) => spectrumTable(atlas, `colored ${light}`, this.coloredOf(lights[light], layers)),
      observer: () => atlas.table('observer', observerTexels),
    };
  }

  private blackbodiesOf(layers: 3 | 4) {
    const known = this.blackbodies.get(layers);
    if (known) return known;
    const table = thermalTable(layers);
    const made = { table, daylight: new DaylightColumns(table) };
    this.blackbodies.set(layers, made);
    return made;
  }

  private coloredOf(light: FilteredBlackbody, layers: 3 | 4): DopplerTable {
    const key = `${layers} ${JSON.stringify(light)}`;
    const table = this.colored.get(key) ?? filteredBlackbodyTable(light, layers);
    this.colored.set(key, table);
    for (const oldest of this.colored.keys()) if (this.colored.size > MAX_CACHED_TABLES) this.colored.delete(oldest);
    return table;
  }
}
