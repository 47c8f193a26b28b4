import { int } from 'three/tsl';
import type { BandColors } from '../shaders/spectrumTable.ts';
import type * as gpu from '../shaders/types.ts';
import { columnOf, type DopplerTable, fromRatio, tableTexel } from '../spectrum/dopplerTable.ts';
import { DAYLIGHT } from '../spectrum/lightSpectrum.ts';
import { luminanceOf, rowOf } from '../spectrum/thermalTable.ts';
import { FloatTable } from './floatTable.ts';

/** What is seen of daylight through each band of a filter that is shifted with it, and Y(T D)/(Y(T) D⁴) of it. */
export interface DaylightColors {
  readonly colors: Omit<BandColors, 'H'>;
  readonly gain: gpu.Float;
}

/** Odd, so that D = 1 is one. From one to the next D changes by 5e-4 at D = 1. */
const STEPS = 8193;

/**
 * The line T = 6504 K · D of a table of blackbodies, so finely that texels are fetched and not filtered, which costs a software GPU half: what nearly all pixels
 * ask for. Over D/(1 + D), layer after layer, with the gain beside the first one.
 */
export class DaylightTable {
  private readonly layers: 3 | 4;
  private readonly table = new FloatTable(1024);

  constructor(blackbodies: DopplerTable) {
    this.layers = blackbodies.layers;
    this.table.reserve(this.layers * STEPS);
    for (let i = 0; i < STEPS; i++) {
      const D = Math.min(Math.max(fromRatio(i / (STEPS - 1)), 1e-4), 1e7);
      const T = DAYLIGHT.temperature * D;
      const [row, column] = [rowOf(blackbodies, T), columnOf(blackbodies, D)];
      for (let layer = 0; layer < this.layers; layer++) {
        const [r, g, b, H] = tableTexel(blackbodies, layer, row, column);
        const gain = layer === 0 ? luminanceOf(H, T) / D ** 4 : 0;
        this.table.values.set([r, g, b, gain], 4 * (layer * STEPS + i));
      }
    }
    this.table.upload();
  }

  at(D: gpu.Float): DaylightColors {
    const step = int(
      D.div(D.add(1))
        .mul(STEPS - 1)
        .add(0.5),
    ).toVar();
    const layer = (k: number): gpu.Vec4 => this.table.texel(step.add(int(k * STEPS))).toVar();
    const red = layer(0);
    const colors = { red: red.xyz, green: layer(1).xyz, blue: layer(2).xyz };
    return { colors: this.layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors, gain: red.w };
  }

  dispose(): void {
    this.table.dispose();
  }
}
