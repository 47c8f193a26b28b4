import { int, vec3 } from 'three/tsl';
import { lerp, type Vec3, ZERO } from '../math/vec3.ts';
import type { BandColors } from '../shaders/spectrumTable.ts';
import type * as gpu from '../shaders/types.ts';
import { WHITE } from '../spectrum/bands.ts';
import { columnOf, type DopplerTable, fromRatio, ratio, tableColor, tableTexel } from '../spectrum/dopplerTable.ts';
import { overlaps } from '../spectrum/filterPairs.ts';
import { DAYLIGHT } from '../spectrum/lightSpectrum.ts';
import { seenColor } from '../spectrum/observerColor.ts';
import { SCATTERED } from '../spectrum/scatteredLight.ts';
import { luminanceOf, rowOf } from '../spectrum/thermalTable.ts';
import { FloatTable } from './floatTable.ts';

/** What is seen of daylight through each band of a filter that is shifted with it, and Y(T D)/(Y(T) D⁴) of it. */
export interface DaylightColors {
  readonly colors: Omit<BandColors, 'H'>;
  readonly gain: gpu.Float;
}

/** What is seen of the scattered light of a sky. */
export interface ScatteredColors {
  /** Linear sRGB, D⁴ left out, of luminance 1 at rest. */
  readonly seen: gpu.Vec3;
  /** The same over white daylight of luminance 1 that is shifted alike: what a filter's `DaylightColors` are multiplied with. */
  readonly ofDaylight: gpu.Vec3;
}

/** What is seen of two filters' overlaps (spectrum/filterPairs.ts). */
export type Overlaps = readonly [rg: gpu.Vec3, gb: gpu.Vec3, br: gpu.Vec3];

/** Odd, so that D = 1 is one. From one to the next D changes by 5e-4 at D = 1. */
const STEPS = 8193;

/**
 * The line T = 6504 K · D of a table of blackbodies, so finely that texels are fetched and not filtered, which costs a software GPU half: what nearly all pixels
 * ask for. Over D/(1 + D), layer after layer, with the gain beside the first one.
 */
export class DaylightTable {
  private readonly layers: 3 | 4;
  private readonly table = new FloatTable(1024);
  /** Those at D = 1; only scenes with coloured lights ask for any. */
  private overlapsAtRest: readonly Vec3[] | undefined;

  constructor(blackbodies: DopplerTable) {
    this.layers = blackbodies.layers;
    this.table.reserve((this.layers + 5) * STEPS);
    const scattered = overShifts((D) => [seenColor(WHITE, WHITE, SCATTERED, 1, D)]);
    for (let i = 0; i < STEPS; i++) {
      const D = shiftOf(i);
      const T = DAYLIGHT.temperature * D;
      const [row, column] = [rowOf(blackbodies, T), columnOf(blackbodies, D)];
      for (let layer = 0; layer < this.layers; layer++) {
        const [r, g, b, H] = tableTexel(blackbodies, layer, row, column);
        const gain = layer === 0 ? luminanceOf(H, T) / D ** 4 : 0;
        this.table.values.set([r, g, b, gain], 4 * (layer * STEPS + i));
      }
      const white = tableColor(blackbodies, row, column, WHITE);
      const [seen] = scattered(D);
      // Channels in which daylight is gone (blue of embers) tell nothing.
      const ofDaylight = seen.map((value, k) => (value * white[k]) / (white[k] ** 2 + 1e-4));
      this.table.values.set([...seen, 0], 4 * (this.layers * STEPS + i));
      this.table.values.set([...ofDaylight, 0], 4 * ((this.layers + 1) * STEPS + i));
    }
    this.table.upload();
  }

  at(D: gpu.Float): DaylightColors {
    const layer = this.layersAt(D);
    const red = layer(0);
    const colors = { red: red.xyz, green: layer(1).xyz, blue: layer(2).xyz };
    return { colors: this.layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors, gain: red.w };
  }

  scattered(D: gpu.Float): ScatteredColors {
    const layer = this.layersAt(D);
    return { seen: layer(this.layers).xyz, ofDaylight: layer(this.layers + 1).xyz };
  }

  /** What Σ (a_i − a_j)(k_i − k_j) over the pairs of bands rg, gb and br is multiplied with; without D at rest. */
  overlaps(D?: gpu.Float): Overlaps {
    const atRest = this.overlapsAtRest ?? this.addOverlaps();
    const layer = D && this.layersAt(D);
    const color = (k: number): gpu.Vec3 => layer?.(this.layers + 2 + k).xyz ?? vec3(...atRest[k]);
    return [color(0), color(1), color(2)];
  }

  private addOverlaps(): readonly Vec3[] {
    const found = overShifts((D) => overlaps(DAYLIGHT.temperature * D, D, this.layers));
    for (let i = 0; i < STEPS; i++)
      found(shiftOf(i)).forEach((color, k) => {
        this.table.values.set([...color, 0], 4 * ((this.layers + 2 + k) * STEPS + i));
      });
    this.table.upload();
    this.overlapsAtRest = found(1);
    return this.overlapsAtRest;
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

const shiftOf = (step: number): number => Math.min(Math.max(fromRatio(step / (STEPS - 1)), 1e-4), 1e7);

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
