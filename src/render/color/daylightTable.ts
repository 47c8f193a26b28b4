import { int } from 'three/tsl';
import { toHalf } from '../../math/half.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { HalfAtlas, HalfTable } from '../../shaders/tables/halfAtlas.ts';
import { type BandColors, luminanceOf } from '../../shaders/tables/spectrumTable.ts';
import type * as gpu from '../../shaders/types.ts';
import { observedColor } from '../../spectrum/color/observerColor.ts';
import { REDDENED, REDDENED_COLORS, SCATTERED, SCATTERED_COLOR } from '../../spectrum/color/scatteredLight.ts';
import {
  columnOf,
  type DopplerTable,
  fromUnitRatio,
  tableColor,
  tableTexel,
  toUnitRatio,
} from '../../spectrum/doppler/dopplerTable.ts';
import {
  bandOverlaps,
  bandTransmission,
  type FilteredBlackbody,
  filteredBlackbodyAtRest,
  sampledSpectrumAtRest,
} from '../../spectrum/doppler/filterPairs.ts';
import { rowOf } from '../../spectrum/doppler/thermalTable.ts';
import { WHITE_FILTER } from '../../spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';

/** What is seen of daylight through each band of a filter that is shifted with it, and Y(T D)/(Y(T) D⁴) of it. */
export interface DaylightColors {
  readonly colors: Omit<BandColors, 'H'>;
  readonly gain: gpu.Float;
}

/** What skies are made of besides white daylight, and what each shows at rest, of luminance 1. */
export const SKY_LIGHTS = [
  { spectrum: SCATTERED, color: SCATTERED_COLOR },
  ...REDDENED.map((spectrum, i) => ({ spectrum, color: REDDENED_COLORS[i] })),
] as const;

/** What the bands of a resting surface show of one of `SKY_LIGHTS`: red, green and blue. */
export const skyBandsAtRest = (light: number): readonly Vec3[] =>
  sampledSpectrumAtRest(SKY_LIGHTS[light].spectrum, 1, bandTransmission(1, 3));

/** What is seen of two filters' overlaps (spectrum/doppler/filterPairs.ts). */
export type Overlaps = readonly [rg: gpu.Vec3, gb: gpu.Vec3, br: gpu.Vec3];

/** Odd, so that D = 1 is one. From one to the next D changes by 5e-4 at D = 1. */
const STEPS = 8193;
/** How a layer of so many texels lies in the atlas. */
const WIDTH = 256;
const ROWS = Math.ceil(STEPS / WIDTH);

/** What a table holds at each of the steps of D: of each layer four numbers. */
type Layers = readonly (readonly number[])[];

/**
 * The line T = 6504 K · D of a table of blackbodies, and of other lights that are shifted so, over D/(1 + D): so finely that texels are fetched and not filtered, which
 * costs a software GPU half. What nearly all pixels ask for. Scenes share what was integrated for one of them.
 */
export class DaylightColumns {
  readonly layers: 3 | 4;
  private readonly blackbodies: DopplerTable;
  private readonly made = new Map<string, Uint16Array>();
  private readonly skies = new Map<number, (D: number) => Layers>();
  /** At `shifts`. */
  private bands: readonly Parameters<typeof filteredBlackbodyAtRest>[2][] | undefined;

  constructor(blackbodies: DopplerTable) {
    this.blackbodies = blackbodies;
    this.layers = blackbodies.layers;
  }

  /** Layer after layer, H beside the first one. */
  daylight(): Uint16Array {
    const { blackbodies } = this;
    return this.cached('daylight', () => (D) => {
      const [row, column] = [rowOf(blackbodies, DAYLIGHT.temperature * D), columnOf(blackbodies, D)];
      return Array.from({ length: this.layers }, (_, layer) => tableTexel(blackbodies, layer, row, column));
    });
  }

  skyColors(light: number): Uint16Array {
    return this.cached(`sky ${light}`, () => this.skyOverShifts(light));
  }

  skyOverDaylight(light: number): Uint16Array {
    return this.cached(`sent ${light}`, () => {
      const seenAt = this.skyOverShifts(light);
      return (D) => [overWhite(seenAt(D)[0], this.white(D))];
    });
  }

  private white(D: number): Vec3 {
    const { blackbodies } = this;
    return tableColor(
      blackbodies,
      rowOf(blackbodies, DAYLIGHT.temperature * D),
      columnOf(blackbodies, D),
      WHITE_FILTER,
    );
  }

  /** Of one of the lights of skies through each band: layer after layer. */
  skyBands(light: number): Uint16Array {
    return this.cached(`bands ${light}`, () => {
      const bands = this.bandsAtShifts();
      return overShifts((D, i) => sampledSpectrumAtRest(SKY_LIGHTS[light].spectrum, D, bands[i].surface));
    });
  }

  overlaps(): Uint16Array {
    return this.cached('overlaps', () => overShifts((D) => bandOverlaps(DAYLIGHT.temperature * D, D, this.layers)));
  }

  /** Of a coloured light: layer after layer, H beside the first one. */
  colored(light: FilteredBlackbody): Uint16Array {
    return this.cached(`colored ${JSON.stringify(light)}`, () => {
      const bands = this.bandsAtShifts();
      return overShifts((D, i) => filteredBlackbodyAtRest(light, D, bands[i]));
    });
  }

  /** Skies are both seen and sent: what is integrated for one is there for the other. */
  private skyOverShifts(light: number): (D: number) => Layers {
    const sky = this.skies.get(light) ?? overShifts((D) => [skyColor(light, D)]);
    this.skies.set(light, sky);
    return sky;
  }

  private bandsAtShifts(): readonly Parameters<typeof filteredBlackbodyAtRest>[2][] {
    this.bands ??= shifts().map((D) => ({ surface: bandTransmission(D, this.layers), light: bandTransmission(D, 3) }));
    return this.bands;
  }

  /** What is integrated takes long: only where it is not known. */
  private cached(name: string, integrated: () => (D: number) => Layers): Uint16Array {
    const known = this.made.get(name) ?? columns(integrated());
    this.made.set(name, known);
    return known;
  }
}

/** Channels in which daylight is gone (blue of embers) tell nothing. */
const overWhite = (seen: readonly number[], white: Vec3): readonly number[] =>
  seen.map((value, k) => (value * white[k]) / (white[k] ** 2 + 1e-4));

const skyColor = (light: number, D: number): Vec3 =>
  observedColor(WHITE_FILTER, WHITE_FILTER, SKY_LIGHTS[light].spectrum, 1, D);

function columns(layersAt: (D: number) => Layers): Uint16Array {
  const steps = Array.from({ length: STEPS }, (_, i) =>
    layersAt(Math.min(Math.max(fromUnitRatio(i / (STEPS - 1)), 1e-4), 1e7)),
  );
  const data = new Uint16Array(4 * ROWS * WIDTH * steps[0].length);
  steps.forEach((layers, i) => {
    layers.forEach((texel, k) => {
      data.set(texel.map(toHalf), 4 * (k * ROWS * WIDTH + i));
    });
  });
  return data;
}

/** `DaylightColumns` as the shaders of a scene read them. */
export class DaylightTable {
  private readonly columns: DaylightColumns;
  private readonly atlas: HalfAtlas;

  constructor(columns: DaylightColumns, atlas: HalfAtlas) {
    this.columns = columns;
    this.atlas = atlas;
  }

  at(D: gpu.Float): DaylightColors {
    const layer = this.read('daylight', () => this.columns.daylight(), D);
    const red = layer(0);
    const colors = { red: red.xyz, green: layer(1).xyz, blue: layer(2).xyz };
    const square = D.mul(D).toVar();
    return {
      colors: this.columns.layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors,
      gain: luminanceOf(red.w, D.mul(DAYLIGHT.temperature)).div(square.mul(square)),
    };
  }

  /** Of a coloured light of a number, seen shifted by D with the surface that it met. */
  colored(number: number, light: FilteredBlackbody, D: gpu.Float): BandColors {
    const layer = this.read(`at rest ${number}`, () => this.columns.colored(light), D);
    const red = layer(0);
    const colors = { red: red.xyz, green: layer(1).xyz, blue: layer(2).xyz, H: red.w };
    return this.columns.layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors;
  }

  /** Linear sRGB, D⁴ left out, of one of the lights of skies (`SKY_LIGHTS`), of luminance 1 at rest. */
  skyColors(light: number, D: gpu.Float): gpu.Vec3 {
    return this.read(`sky ${light}`, () => this.columns.skyColors(light), D)(0).xyz;
  }

  /** The same through each band of a filter that is shifted with it. */
  skyBands(light: number, D: gpu.Float): DaylightColors['colors'] {
    const layer = this.read(`bands ${light}`, () => this.columns.skyBands(light), D);
    const colors = { red: layer(0).xyz, green: layer(1).xyz, blue: layer(2).xyz };
    return this.columns.layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors;
  }

  /** The same over white daylight of luminance 1 that is shifted alike: what light is multiplied with that came shifted. */
  skyOverDaylight(light: number, D: gpu.Float): gpu.Vec3 {
    return this.read(`sent ${light}`, () => this.columns.skyOverDaylight(light), D)(0).xyz;
  }

  /** What Σ (a_i − a_j)(k_i − k_j) over the pairs of bands rg, gb and br is multiplied with. */
  overlaps(D: gpu.Float): Overlaps {
    const layer = this.read('overlaps', () => this.columns.overlaps(), D);
    return [layer(0).xyz, layer(1).xyz, layer(2).xyz];
  }

  private read(name: string, data: () => Uint16Array, D: gpu.Float): (layer: number) => gpu.Vec4 {
    const table: HalfTable = this.atlas.table(name, () => ({ data: data(), width: WIDTH }));
    const step = int(
      D.div(D.add(1))
        .mul(STEPS - 1)
        .add(0.5),
    ).toVar();
    return (layer) => table.load(step.add(int(layer * ROWS * WIDTH)));
  }
}

/** Of how many shifts colours are integrated; between them they go straight, within 2e-3. Odd, so that D = 1 is one. */
const NODES = 513;

/** All but the first, D = 0, and the last, ∞. */
const shifts = (): readonly number[] =>
  Array.from({ length: NODES - 2 }, (_, i) => fromUnitRatio((i + 1) / (NODES - 1)));

function overShifts(layersAt: (D: number, i: number) => Layers): (D: number) => Layers {
  const nodes = shifts().map(layersAt);
  const dark = nodes[0].map((texel) => texel.map(() => 0));
  return (D) => {
    const place = (NODES - 1) * toUnitRatio(D);
    const i = Math.min(Math.floor(place), NODES - 2);
    const [a, b] = [nodes[i - 1] ?? dark, nodes[i] ?? dark];
    return a.map((texel, k) => texel.map((value, channel) => value + (b[k][channel] - value) * (place - i)));
  };
}
