import { clamp, exp, Fn, float, min, select, texture, vec2 } from 'three/tsl';
import type { Texture } from 'three/webgpu';
import { SHIFT_LIMIT } from '../spectrum/dopplerTable.ts';
import { DAYLIGHT } from '../spectrum/lightSpectrum.ts';
import { LUMINANCE_THETA, MIDDLE_TEMPERATURE } from '../spectrum/thermalTable.ts';
import type { Float, Vec3, Vec4 } from './types.ts';

/** A `DopplerTable` on the GPU, its layers one under the other, linearly filtered. */
export interface SpectrumTable {
  readonly texture: Texture;
  readonly layers: 3 | 4;
  readonly columns: number;
  readonly rows: number;
}

/** What is seen through each band of a filter, linear sRGB, of light of luminance 1. */
export interface BandColors {
  readonly red: Vec3;
  readonly green: Vec3;
  readonly blue: Vec3;
  /** Through its ultraviolet or infrared, in tables of four layers. */
  readonly beyond?: Vec3;
  /** H of `luminanceOf`. */
  readonly H: Float;
}

/** Half of what D/(1 + D) spans. */
export const FARTHEST = SHIFT_LIMIT / (1 + SHIFT_LIMIT) - 0.5;

/** The colours of the bands of a filter that is seen shifted by D, of a blackbody that is seen at T [K]: `tableTexel` at `rowOf` and `columnOf`. */
export function thermalColors({ texture: data, layers, columns, rows }: SpectrumTable, T: Float, D: Float): BandColors {
  const shift = D.div(D.add(1))
    .sub(0.5)
    .div(2 * FARTHEST);
  const across = clamp(shift.add(0.5), 0, 1)
    .mul(columns - 1)
    .add(0.5)
    .div(columns)
    .toVar();
  const row = T.div(T.add(MIDDLE_TEMPERATURE))
    .mul(rows - 1)
    .add(0.5)
    .toVar();
  const layer = (k: number): Vec4 => {
    // The base level, for neighbours may not have read it; and not times the texture's matrix.
    const texel = texture(data, vec2(across, row.add(k * rows).div(layers * rows))).level(float(0));
    texel.updateMatrix = false;
    return texel.toVar();
  };
  const red = layer(0);
  const colors = { red: red.xyz, green: layer(1).xyz, blue: layer(2).xyz, H: red.w };
  return layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors;
}

/** What is seen through a filter: (r, g, b, and in tables of four layers its ultraviolet where D < 1, else its infrared). */
export function filteredColor({ red, green, blue, beyond }: Omit<BandColors, 'H'>, filter: Vec4): Vec3 {
  const inside = red.mul(filter.x).add(green.mul(filter.y)).add(blue.mul(filter.z));
  return beyond ? inside.add(beyond.mul(filter.w)) : inside;
}

const OF_DAYLIGHT = Math.expm1(LUMINANCE_THETA / DAYLIGHT.temperature);

/** Y(T)/Y(6504 K) of a blackbody of T [K] whose H is given: H (e^{θ/6504 K} − 1)/(e^{θ/T} − 1), the denominator as a series where θ/T is small. */
export const luminanceOf = Fn(
  ([H, T]: [Float, Float]): Float => {
    const x = min(T.reciprocal().mul(LUMINANCE_THETA), 85).toVar();
    const series = x.mul(x.mul(x.div(3).add(1)).div(2).add(1));
    return H.mul(OF_DAYLIGHT).div(select(x.lessThan(0.03), series, exp(x).sub(1)));
  },
  { H: 'float', T: 'float', return: 'float' },
);
