import { directLights, hasDomeLight, sceneDome } from '../../scene/lights/sceneLights.ts';
import type { Scene } from '../../scene/types.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { isLuminous } from '../../scene/views/views.ts';
import type { HalfAtlas } from '../../shaders/tables/halfAtlas.ts';
import { observerTexels } from '../../shaders/tables/observerTable.ts';
import { spectrumTable } from '../../shaders/tables/spectrumTable.ts';
import type { DopplerTable } from '../../spectrum/doppler/dopplerTable.ts';
import { type FilteredBlackbody, filteredBlackbodyTable } from '../../spectrum/doppler/filterPairs.ts';
import { RGB_COLOR_MODES, type RgbColorMode } from '../../spectrum/doppler/rgbShifts.ts';
import { thermalTable } from '../../spectrum/doppler/thermalTable.ts';
import { DaylightColumns, DaylightTable, SKY_LIGHTS } from './daylightTable.ts';
import { coloredLights, domeSpectrumKind, spectrumKindOf } from './lightSpectra.ts';
import type { ColorPipeline } from './radiance.ts';
import { type SpectralTables, spectralPipeline } from './spectralPipeline.ts';
import { restPipeline, rgbShiftPipeline, unshiftedPipeline } from './srgbPipelines.ts';

/**
 * How colours are computed in compiled passes. By spectra: `spectral`; `physical` if the whole shift applies to colours and brightness, which needs no
 * powers; `resting` if nothing is shifted and all light is daylight. Without spectra: by the mode's shift; `plain` if nothing is shifted.
 */
export type ColorVariant = 'spectral' | 'physical' | 'resting' | RgbColorMode | 'plain';

/** The variant for these settings. Code for shifts is left out where none is shown, because a software GPU pays for it even then. */
export function colorVariantOf(settings: RenderSettings, scene: Scene): ColorVariant {
  const { colors, dopplerMix, beaming } = settings;
  const isShifted = isLuminous(settings) && (dopplerMix > 0 || beaming > 0);
  if (colors !== 'spectral') return isShifted ? colors : 'plain';
  if (isShifted) return dopplerMix === 1 && beaming === 1 ? 'physical' : 'spectral';
  const daylight =
    domeSpectrumKind(sceneDome(scene)) === 'daylight' &&
    directLights(scene).every((light) => spectrumKindOf(light) === 'daylight') &&
    !scene.materials.some(isGlowing);
  return daylight ? 'resting' : 'spectral';
}

const isRgbMode = (variant: ColorVariant): variant is RgbColorMode =>
  (RGB_COLOR_MODES as readonly string[]).includes(variant);

const isGlowing = ({ emissionTemperature }: Scene['materials'][number]): boolean => emissionTemperature !== undefined;

/** Tables of coloured lights, of this scene and of earlier ones, that are kept. */
const MAX_CACHED_TABLES = 60;

interface BlackbodyTables {
  readonly table: DopplerTable;
  readonly daylight: DaylightColumns;
}

/** By number of layers; computed on first use, which takes half a second. */
const blackbodyTables = new Map<3 | 4, BlackbodyTables>();

function blackbodyTablesOf(layers: 3 | 4): BlackbodyTables {
  const cached = blackbodyTables.get(layers);
  if (cached) return cached;
  const table = thermalTable(layers);
  const tables = { table, daylight: new DaylightColumns(table) };
  blackbodyTables.set(layers, tables);
  return tables;
}

/** Computes what nearly all scenes need, a table at each step, before the first scene is there. */
export function* commonTables(): Generator<void> {
  const { daylight } = blackbodyTablesOf(3);
  yield;
  daylight.daylight();
  for (const light of SKY_LIGHTS.keys()) {
    yield;
    daylight.skyColors(light);
    yield;
    daylight.skyBands(light);
    yield;
    daylight.skyOverDaylight(light);
  }
  yield;
  daylight.overlaps();
}

/** The tables of spectral colours. Scenes share them, but each uploads its own copy. */
export class ColorPipelines {
  private readonly colored = new Map<string, DopplerTable>();

  /** `atlas`: the scene's. */
  pipeline(variant: ColorVariant, scene: Scene, atlas: HalfAtlas): ColorPipeline {
    const { materials } = scene;
    const glowing = materials.some(isGlowing);
    if (isRgbMode(variant)) return rgbShiftPipeline(variant, glowing);
    if (variant === 'plain' || variant === 'resting')
      return variant === 'plain' ? unshiftedPipeline(glowing) : restPipeline(hasDomeLight(scene));
    const layers = materials.some(({ uv, ir }) => uv !== undefined || ir !== undefined) ? 4 : 3;
    return spectralPipeline(this.tables(scene, layers, atlas), {
      glowing,
      reddenedSky: hasDomeLight(scene),
      fullShift: variant === 'physical',
    });
  }

  private tables(scene: Scene, layers: 3 | 4, atlas: HalfAtlas): SpectralTables {
    const { table, daylight } = blackbodyTablesOf(layers);
    const lights = coloredLights(scene);
    return {
      blackbodies: spectrumTable(atlas, 'blackbodies', table),
      daylight: new DaylightTable(daylight, atlas),
      lights,
      colored: (light) => spectrumTable(atlas, `colored ${light}`, this.coloredOf(lights[light], layers)),
      observer: () => atlas.table('observer', observerTexels),
    };
  }

  private coloredOf(light: FilteredBlackbody, layers: 3 | 4): DopplerTable {
    const key = `${layers} ${JSON.stringify(light)}`;
    const table = this.colored.get(key) ?? filteredBlackbodyTable(light, layers);
    this.colored.set(key, table);
    for (const oldest of this.colored.keys()) if (this.colored.size > MAX_CACHED_TABLES) this.colored.delete(oldest);
    return table;
  }
}
