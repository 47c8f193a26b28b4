import { clamp, float, texture, vec2 } from 'three/tsl';
import type { Texture } from 'three/webgpu';
import { type BandColors, FARTHEST } from './spectrumTable.ts';
import type { Float, Vec4 } from './types.ts';

/** The `coloredTable`s of lights on the GPU, one under the other, linearly filtered. */
export interface ColoredTables {
  readonly texture: Texture;
  readonly layers: 3 | 4;
  readonly steps: number;
  readonly count: number;
}

/** The colours of the bands of a filter that is seen shifted by `out`, of the light of a number that is seen shifted by `whole`, both within `SHIFT_LIMIT`. */
export function coloredColors(tables: ColoredTables, light: number, whole: Float, out: Float): BandColors {
  const { texture: data, layers, steps, count } = tables;
  const place = (D: Float): Float => {
    const shift = D.div(D.add(1))
      .sub(0.5)
      .div(2 * FARTHEST);
    return clamp(shift.add(0.5), 0, 1)
      .mul(steps - 1)
      .add(0.5)
      .toVar();
  };
  const [across, row] = [place(out).div(steps).toVar(), place(whole)];
  const layer = (k: number): Vec4 => {
    const down = row.add((light * layers + k) * steps).div(steps * layers * count);
    // The base level, for neighbours may not have read it; and not times the texture's matrix.
    const texel = texture(data, vec2(across, down)).level(float(0));
    texel.updateMatrix = false;
    return texel.toVar();
  };
  const red = layer(0);
  const colors = { red: red.xyz, green: layer(1).xyz, blue: layer(2).xyz, H: red.w };
  return layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors;
}
