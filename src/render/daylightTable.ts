import { int } from 'three/tsl';
import { lerp, type Vec3, ZERO } from '../math/vec3.ts';
import type { BandColors } from '../shaders/spectrumTable.ts';
import type * as gpu from '../shaders/types.ts';
import { WHITE } from '../spectrum/bands.ts';
import { columnOf, type DopplerTable, fromRatio, ratio, tableColor, tableTexel } from '../spectrum/dopplerTable.ts';
import { overlaps } from '../spectrum/filterPairs.ts';
import { DAYLIGHT } from '../spectrum/lightSpectrum.ts';
import { seenColor } from '../spectrum/observerColor.ts';
import { REDDENED, REDDENED_COLORS, SCATTERED, SCATTERED_COLOR } from '../spectrum/scatteredLight.ts';
import { luminanceOf, rowOf } from '../spectrum/thermalTable.ts';
import { FloatTable } from './floatTable.ts';

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

/** What is seen of two filters' overlaps (spectrum/filterPairs.ts). */
export type Overlaps = readonly [rg: gpu.Vec3, gb: gpu.Vec3, br: gpu.Vec3];

/** Odd, so that D = 1 is one. From one to the next D changes by 5e-4 at D = 1. */
const STEPS = 8193;

/**
 * The line T = 6504 K · D of a table of blackbodies, so finely that texels are fetched and not filtered, which costs a software GPU half: what nearly all pixels
 * ask for. Over D/(1 + D), layer after layer, with the gain beside the first one.
 */
export class DaylightTable {
  private readonly blackbodies: DopplerTable;
  private readonly layers: 3 | 4;
  private readonly table = new FloatTable(1024);
  /** The layers that only some scenes ask for: where each group of them begins. */
  private readonly begins = new Map<string, number>();
  private used: number;

  constructor(blackbodies: DopplerTable) {
    this.blackbodies = blackbodies;
    this.layers = blackbodies.layers;
    this.used = this.layers;
    this.table.reserve(this.layers * STEPS);
    for (let i = 0; i < STEPS; i++) {
      const { D, T, row, column } = this.place(i);
      for (let layer = 0; layer < this.layers; layer++) {
        const [r, g, b, H] = tableTexel(blackbodies, layer, row, column);
        const gain = layer === 0 ? luminanceOf(H, T) / D ** 4 : 0;
        this.table.values.set([r, g, b, gain], 4 * (layer * STEPS + i));
      }
    }
    this.table.upload();
  }

  at(D: gpu.Float): DaylightColors {
    const layer = this.layersAt(D);
    const red = layer(0);
    const colors = { red: red.xyz, green: layer(1).xyz, blue: layer(2).xyz };
    return { colors: this.layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors, gain: red.w };
  }

  /** Linear sRGB, D⁴ left out, of one of the lights of skies (`SKY_LIGHTS`), of luminance 1 at rest. */
  skySeen(light: number, D: gpu.Float): gpu.Vec3 {
    const { spectrum } = SKY_LIGHTS[light];
    const first = this.first(`sky ${light}`, (D) => [seenColor(WHITE, WHITE, spectrum, 1, D)], 1);
    return this.layersAt(D)(first).xyz;
  }

  /** The same over white daylight of luminance 1 that is shifted alike: what a filter's `DaylightColors` are multiplied with. */
  skyOfDaylight(light: number, D: gpu.Float): gpu.Vec3 {
    const { spectrum } = SKY_LIGHTS[light];
    const colors = (D: number) => [seenColor(WHITE, WHITE, spectrum, 1, D)];
    const first = this.first(`sent ${light}`, colors, 1, ([seen], i) => {
      const { row, column } = this.place(i);
      const white = tableColor(this.blackbodies, row, column, WHITE);
      // Channels in which daylight is gone (blue of embers) tell nothing.
      const over = (k: number) => (seen[k] * white[k]) / (white[k] ** 2 + 1e-4);
      return [[over(0), over(1), over(2)]];
    });
    return this.layersAt(D)(first).xyz;
  }

  /** What Σ (a_i − a_j)(k_i − k_j) over the pairs of bands rg, gb and br is multiplied with. */
  overlaps(D: gpu.Float): Overlaps {
    const first = this.first('overlaps', (D) => overlaps(DAYLIGHT.temperature * D, D, this.layers), 3);
    const layer = this.layersAt(D);
    return [layer(first).xyz, layer(first + 1).xyz, layer(first + 2).xyz];
  }

  /** The first of some layers, integrated when they are asked for. */
  private first(
    name: string,
    colors: (D: number) => readonly Vec3[],
    count: number,
    held: (colors: readonly Vec3[], step: number) => readonly Vec3[] = (colors) => colors,
  ): number {
    const known = this.begins.get(name);
    if (known !== undefined) return known;
    const first = this.used;
    this.used += count;
    this.begins.set(name, first);
    this.table.reserve(this.used * STEPS);
    const found = overShifts(colors);
    for (let i = 0; i < STEPS; i++)
      held(found(this.place(i).D), i).forEach((color, k) => {
        this.table.values.set([...color, 0], 4 * ((first + k) * STEPS + i));
      });
    this.table.upload();
    return first;
  }

  private place(step: number): {
    readonly D: number;
    readonly T: number;
    readonly row: number;
    readonly column: number;
  } {
    const D = Math.min(Math.max(fromRatio(step / (STEPS - 1)), 1e-4), 1e7);
    const T = DAYLIGHT.temperature * D;
    return { D, T, row: rowOf(this.blackbodies, T), column: columnOf(this.blackbodies, D) };
  }

  private layersAt(D: gpu.Float): (layer: number) => gpu.Vec4 {
    const step = int(
      D.div(D.add(1))
        .mul(STEPS - 1)
        .add(0.5),
    ).toVar();
    return (layer) => this.table.texel(step.add(int(layer * STEPS))).toVar();
  }

  dispose(): void {
    this.table.dispose();
  }
}

/** Of how many shifts colours are integrated; between them they go straight, within 2e-3. Odd, so that D = 1 is one. */
const NODES = 513;

function overShifts(colors: (D: number) => readonly Vec3[]): (D: number) => readonly Vec3[] {
  const nodes = Array.from({ length: NODES }, (_, i) => {
    const D = fromRatio(i / (NODES - 1));
    return D > 0 && Number.isFinite(D) ? colors(D) : undefined;
  });
  const dark = nodes[1]!.map(() => ZERO);
  return (D) => {
    const place = (NODES - 1) * ratio(D);
    const i = Math.min(Math.floor(place), NODES - 2);
    const [a, b] = [nodes[i] ?? dark, nodes[i + 1] ?? dark];
    return a.map((color, k) => lerp(color, b[k], place - i));
  };
}
