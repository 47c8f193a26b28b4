import { floor, int } from 'three/tsl';
import { toHalf } from '../../math/half.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { HalfAtlas, HalfTable } from '../../shaders/tables/halfAtlas.ts';
import { type BandColors, luminanceOf } from '../../shaders/tables/spectrumTable.ts';
import type * as gpu from '../../shaders/types.ts';
import { REDDENED, REDDENED_COLORS, SCATTERED, SCATTERED_COLOR } from '../../spectrum/color/scatteredLight.ts';
import {
  columnOf,
  type DopplerTable,
  fromUnitRatio,
  shapeChannels,
  tableShape,
  tableTexel,
  toUnitRatio,
} from '../../spectrum/doppler/dopplerTable.ts';
import {
  bandOverlaps,
  bandTransmission,
  type FilteredBlackbody,
  filteredBlackbodyAtRest,
  type PairedBands,
  pairedBands,
  sampledSpectrumAtRest,
} from '../../spectrum/doppler/filterPairs.ts';
import { rowOf } from '../../spectrum/doppler/thermalTable.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';

/** Colours of daylight through each band of a filter that is shifted with it, and its Y(T D)/(Y(T) D⁴). */
export interface DaylightColors {
  readonly colors: Omit<BandColors, 'G'>;
  readonly gain: gpu.Float;
}

/** The lights that skies are composed of besides white daylight, and the colour of each at rest, with luminance 1. */
export const SKY_LIGHTS = [
  { spectrum: SCATTERED, color: SCATTERED_COLOR },
  ...REDDENED.map((spectrum, i) => ({ spectrum, color: REDDENED_COLORS[i] })),
] as const;

/** The colours of one of `SKY_LIGHTS` through the red, green and blue band of a surface at rest. */
export const skyBandsAtRest = (light: number): readonly Vec3[] =>
  sampledSpectrumAtRest(SKY_LIGHTS[light].spectrum, 1, bandTransmission(1, 3));

/** The colours of two filters' overlaps (spectrum/doppler/filterPairs.ts). */
export type Overlaps = readonly [rg: gpu.Vec3, gb: gpu.Vec3, br: gpu.Vec3];

/** Odd, so that D = 1 is one of them. Near D = 1 a step changes D by 5e-4. */
const STEPS = 8193;
/** A layer is stored in the atlas in rows of this many texels. */
const WIDTH = 256;
const ROWS = Math.ceil(STEPS / WIDTH);

/** Writes the colours of a light at a shift, three numbers per layer. */
type ColorsAt = (D: number, out: Float64Array) => void;

/**
 * The line T = 6504 K · D of a table of blackbodies, and of other lights that are shifted in this way, over D/(1 + D): so fine that texels are fetched
 * without filtering, which halves the cost on a software GPU. Nearly all pixels read this. Scenes share what was integrated for one of them.
 */
export class DaylightColumns {
  readonly layers: 3 | 4;
  private readonly blackbodies: DopplerTable;
  private readonly cache = new Map<string, Uint16Array>();
  private readonly skies = new Map<number, ColorsAt>();
  /** Of the bands at `shifts`. */
  private bands: readonly PairedBands[] | undefined;

  constructor(blackbodies: DopplerTable) {
    this.blackbodies = blackbodies;
    this.layers = blackbodies.layers;
  }

  /** Layer after layer; G and its slope in the fourth channels (`columns`). */
  daylight(): Uint16Array {
    return this.cached('daylight', this.layers, () => this.daylightAt, this.shapeOf(DAYLIGHT.temperature));
  }

  /** One of the lights of skies, unfiltered. */
  skyColors(light: number): Uint16Array {
    return this.cached(`sky ${light}`, 1, () => {
      const bandsAt = this.skyOverShifts(light);
      const bands = new Float64Array(3 * this.layers);
      return (D, out) => {
        bandsAt(D, bands);
        sumLayers(bands, out);
      };
    });
  }

  skyOverDaylight(light: number): Uint16Array {
    return this.cached(`sent ${light}`, 1, () => {
      const bandsAt = this.skyOverShifts(light);
      const bands = new Float64Array(3 * this.layers);
      const white = new Float64Array(3);
      return (D, out) => {
        this.daylightAt(D, bands);
        sumLayers(bands, white);
        bandsAt(D, bands);
        sumLayers(bands, out);
        // Where a channel of daylight vanishes (blue of embers), the quotient tends to 0.
        for (let k = 0; k < 3; k++) out[k] *= white[k] / (white[k] ** 2 + 1e-4);
      };
    });
  }

  /** One of the lights of skies through each band, layer after layer. */
  skyBands(light: number): Uint16Array {
    return this.cached(`bands ${light}`, this.layers, () => this.skyOverShifts(light));
  }

  overlaps(): Uint16Array {
    const integrate = () => {
      const bands = this.bandsAtShifts();
      return overShifts(3, (D, i) => bandOverlaps(DAYLIGHT.temperature * D, bands[i]));
    };
    return this.cached('overlaps', 3, integrate);
  }

  /** A coloured light, layer after layer; G and its slope in the fourth channels. */
  colored(light: FilteredBlackbody): Uint16Array {
    const integrate = () => {
      const bands = this.bandsAtShifts();
      return overShifts(this.layers, (D, i) => filteredBlackbodyAtRest(light, D, bands[i]));
    };
    return this.cached(`colored ${JSON.stringify(light)}`, this.layers, integrate, this.shapeOf(light.temperature));
  }

  private readonly daylightAt: ColorsAt = (D, out) => {
    const { blackbodies } = this;
    const [row, column] = [rowOf(blackbodies, DAYLIGHT.temperature * D), columnOf(blackbodies, D)];
    for (let layer = 0; layer < this.layers; layer++) out.set(tableTexel(blackbodies, layer, row, column), 3 * layer);
  };

  /** The bands of a sky's light, whose sum is the light: skies are both seen directly and reflected. */
  private skyOverShifts(light: number): ColorsAt {
    const { spectrum } = SKY_LIGHTS[light];
    const integrate = () => {
      const bands = this.bandsAtShifts();
      return overShifts(this.layers, (D, i) => sampledSpectrumAtRest(spectrum, D, bands[i].surface));
    };
    const sky = this.skies.get(light) ?? integrate();
    this.skies.set(light, sky);
    return sky;
  }

  private bandsAtShifts(): readonly PairedBands[] {
    this.bands ??= shifts().map((D) => pairedBands(D, this.layers));
    return this.bands;
  }

  /** G of a blackbody of T [K] that is shifted by D. */
  private shapeOf(T: number): (D: number) => number {
    return (D) => tableShape(this.blackbodies, rowOf(this.blackbodies, T * D));
  }

  /** Integrates only on first use, because integration takes long. */
  private cached(
    name: string,
    layers: number,
    integrate: () => ColorsAt,
    shapeAt?: (D: number) => number,
  ): Uint16Array {
    const columnsData = this.cache.get(name) ?? columns(layers, integrate(), shapeAt);
    this.cache.set(name, columnsData);
    return columnsData;
  }
}

/** The light that passes one of the layers. */
function sumLayers(layers: Float64Array, out: Float64Array): void {
  out.fill(0);
  for (let i = 0; i < layers.length; i++) out[i % 3] += layers[i];
}

/** The layers at all steps; with `shapeAt` their fourth channels are those of `shapeChannels`, with the slope from step to step. */
function columns(layers: number, colorsAt: ColorsAt, shapeAt?: (D: number) => number): Uint16Array {
  const shiftOf = (i: number): number => Math.min(Math.max(fromUnitRatio(i / (STEPS - 1)), 1e-4), 1e7);
  const shapes =
    shapeAt &&
    shapeChannels(
      Array.from({ length: STEPS }, (_, i) => shapeAt(shiftOf(i))),
      slope,
    );
  const data = new Uint16Array(4 * ROWS * WIDTH * layers);
  const colors = new Float64Array(3 * layers);
  for (let i = 0; i < STEPS; i++) {
    colorsAt(shiftOf(i), colors);
    for (let layer = 0; layer < layers; layer++) {
      const at = 4 * (layer * ROWS * WIDTH + i);
      for (let k = 0; k < 3; k++) data[at + k] = toHalf(colors[3 * layer + k]);
      if (shapes && layer < 3) data[at + 3] = toHalf(shapes[i][layer]);
    }
  }
  return data;
}

const slope = (before: number, _: number, after: number): number => (after - before) / 2;

/** `DaylightColumns` as the shaders of a scene read them. */
export class DaylightTable {
  private readonly columns: DaylightColumns;
  private readonly atlas: HalfAtlas;

  constructor(columns: DaylightColumns, atlas: HalfAtlas) {
    this.columns = columns;
    this.atlas = atlas;
  }

  at(D: gpu.Float): DaylightColors {
    const { G, ...colors } = this.readLight('daylight', () => this.columns.daylight(), D);
    const square = D.mul(D).toVar();
    return {
      colors,
      gain: luminanceOf(G, D.mul(DAYLIGHT.temperature)).div(square.mul(square)),
    };
  }

  /** A coloured light, by its number, whose light is seen shifted by D together with the surface that reflects it. */
  colored(number: number, light: FilteredBlackbody, D: gpu.Float): BandColors {
    return this.readLight(`at rest ${number}`, () => this.columns.colored(light), D);
  }

  /** Linear sRGB, without D⁴, of one of the lights of skies (`SKY_LIGHTS`), with luminance 1 at rest. */
  skyColors(light: number, D: gpu.Float): gpu.Vec3 {
    return this.read(`sky ${light}`, () => this.columns.skyColors(light), D)(0).xyz;
  }

  /** `skyColors` through each band of a filter that is shifted with the light. */
  skyBands(light: number, D: gpu.Float): DaylightColors['colors'] {
    const layer = this.read(`bands ${light}`, () => this.columns.skyBands(light), D);
    const colors = { red: layer(0).xyz, green: layer(1).xyz, blue: layer(2).xyz };
    return this.columns.layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors;
  }

  /** `skyColors` over white daylight of luminance 1 with the same shift: the factor for light that arrives shifted. */
  skyOverDaylight(light: number, D: gpu.Float): gpu.Vec3 {
    return this.read(`sent ${light}`, () => this.columns.skyOverDaylight(light), D)(0).xyz;
  }

  /** The colours that Σ (a_i − a_j)(k_i − k_j) over the pairs of bands rg, gb and br is multiplied with. */
  overlaps(D: gpu.Float): Overlaps {
    const layer = this.read('overlaps', () => this.columns.overlaps(), D);
    return [layer(0).xyz, layer(1).xyz, layer(2).xyz];
  }

  /** The bands of a light, with G at D itself and not at its nearest step. */
  private readLight(name: string, data: () => Uint16Array, D: gpu.Float): BandColors {
    const layer = this.read(name, data, D);
    const [red, green, blue] = [layer(0), layer(1), layer(2)];
    const position = positionOf(D).toVar();
    const G = red.w.add(green.w).add(position.sub(floor(position.add(0.5))).mul(blue.w));
    const colors = { red: red.xyz, green: green.xyz, blue: blue.xyz, G };
    return this.columns.layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors;
  }

  private read(name: string, data: () => Uint16Array, D: gpu.Float): (layer: number) => gpu.Vec4 {
    const table: HalfTable = this.atlas.table(name, () => ({ data: data(), width: WIDTH }));
    const step = int(positionOf(D).add(0.5)).toVar();
    return (layer) => table.load(step.add(int(layer * ROWS * WIDTH)));
  }
}

/** Steps up to a shift, 0 … STEPS − 1. */
const positionOf = (D: gpu.Float): gpu.Float => D.div(D.add(1)).mul(STEPS - 1);

/**
 * Number of shifts at which colours are integrated; between them they are interpolated linearly, with an error within 2e-3. Odd, so that D = 1 is one of
 * them.
 */
const NODES = 513;

/** All but the first, D = 0, and the last, ∞. */
const shifts = (): readonly number[] =>
  Array.from({ length: NODES - 2 }, (_, i) => fromUnitRatio((i + 1) / (NODES - 1)));

/** Integrates at the shifts, `layers` colours each; black at D = 0 and ∞. */
function overShifts(layers: number, colorsAt: (D: number, i: number) => readonly Vec3[]): ColorsAt {
  const size = 3 * layers;
  const nodes = new Float64Array(NODES * size);
  shifts().forEach((D, i) => {
    colorsAt(D, i).forEach((color, layer) => {
      nodes.set(color, (i + 1) * size + 3 * layer);
    });
  });
  return (D, out) => {
    const position = (NODES - 1) * toUnitRatio(D);
    const i = Math.min(Math.floor(position), NODES - 2);
    const fraction = position - i;
    for (let k = 0, at = i * size; k < size; k++, at++) out[k] = nodes[at] + (nodes[at + size] - nodes[at]) * fraction;
  };
}
