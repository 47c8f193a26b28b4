import { clamp, exp, Fn, fract, max, select } from 'three/tsl';
import { type DopplerTable, SHIFT_LIMIT } from '../../spectrum/doppler/dopplerTable.ts';
import { DARK_TEMPERATURE, LUMINANCE_THETA, MIDDLE_TEMPERATURE } from '../../spectrum/doppler/thermalTable.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import type { Float, Vec3, Vec4 } from '../types.ts';
import type { HalfAtlas, HalfTable } from './halfAtlas.ts';

/** A `DopplerTable` on the GPU, with its layers one below the other. */
export interface SpectrumTable {
  readonly table: HalfTable;
  readonly layers: 3 | 4;
  readonly columns: number;
  readonly rows: number;
}

/** Observed colour of each band of a filter, linear sRGB, in light of luminance 1. */
export interface BandColors {
  readonly red: Vec3;
  readonly green: Vec3;
  readonly blue: Vec3;
  /** Of its ultraviolet or infrared, in tables of four layers. */
  readonly beyond?: Vec3;
  /** G of `blackbodyLuminance`. */
  readonly G: Float;
}

/** Puts a table into the atlas. */
export function spectrumTable(
  atlas: HalfAtlas,
  name: string,
  { data, layers, columns, rows }: DopplerTable,
): SpectrumTable {
  return { table: atlas.table(name, () => ({ data, width: columns })), layers, columns, rows };
}

/** Half of the range of D/(1 + D). */
const HALF_SPAN = SHIFT_LIMIT / (1 + SHIFT_LIMIT) - 0.5;

/** The band colours of a filter observed with the shift D, in light of a blackbody observed at T [K]: `tableTexel` at `rowOf` and `columnOf`. */
export const thermalColors = (table: SpectrumTable, T: Float, D: Float): BandColors =>
  colorsAt(table, coordinateOf(D, table.columns), T.div(T.add(MIDDLE_TEMPERATURE)).mul(table.rows - 1));

/**
 * The band colours of a filter observed with the shift `out`, in coloured light observed with the shift `whole`, both within
 * `SHIFT_LIMIT`; from the light's `filteredBlackbodyTable`.
 */
export const coloredColors = (table: SpectrumTable, whole: Float, out: Float): BandColors =>
  colorsAt(table, coordinateOf(out, table.columns), coordinateOf(whole, table.rows));

/** `columnOf`: 0 to steps − 1. */
function coordinateOf(D: Float, steps: number): Float {
  const shift = D.div(D.add(1))
    .sub(0.5)
    .div(2 * HALF_SPAN);
  return clamp(shift.add(0.5), 0, 1).mul(steps - 1);
}

function colorsAt({ table, layers, rows }: SpectrumTable, column: Float, row: Float): BandColors {
  const [across, down] = [column.add(0.5).toVar(), row.add(0.5).toVar()];
  const layer = (k: number): Vec4 => table.sampleLinear(across, down.add(k * rows));
  const [red, green, blue] = [layer(0), layer(1), layer(2)];
  const between = fract(row).toVar();
  const G = red.w.add(green.w).sub(between.mul(between.oneMinus()).mul(blue.w).mul(0.5));
  const colors = { red: red.xyz, green: green.xyz, blue: blue.xyz, G };
  return layers === 4 ? { ...colors, beyond: layer(3).xyz } : colors;
}

/** Observed colour of a filter (r, g, b, and for tables of four layers its ultraviolet where D < 1, else its infrared). */
export function filteredColor({ red, green, blue, beyond }: Omit<BandColors, 'G'>, filter: Vec4): Vec3 {
  const inside = red.mul(filter.x).add(green.mul(filter.y)).add(blue.mul(filter.z));
  return beyond ? inside.add(beyond.mul(filter.w)) : inside;
}

const OF_DAYLIGHT = Math.expm1(LUMINANCE_THETA / DAYLIGHT.temperature);

/** Twin of `blackbodyLuminance`, T [K]: the denominator is divided by e^{θ/T}, and has its series for small θ/T. */
export const luminanceOf = Fn(
  ([G, T]: [Float, Float]): Float => {
    const inverse = max(T, DARK_TEMPERATURE).reciprocal().toVar();
    const x = inverse.mul(LUMINANCE_THETA).toVar();
    const log = inverse.mul(MIDDLE_TEMPERATURE).add(1).mul(G).sub(x);
    const series = x.mul(x.mul(x.div(3).oneMinus()).div(2).oneMinus());
    return exp(log)
      .mul(OF_DAYLIGHT)
      .div(select(x.lessThan(0.03), series, exp(x.negate()).oneMinus()));
  },
  { G: 'float', T: 'float', return: 'float' },
);
