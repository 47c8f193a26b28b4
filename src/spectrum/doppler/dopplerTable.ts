import { fromHalf, toHalf } from '../../math/half.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { toLinearSrgb } from '../color/observerColor.ts';
import { colorMatching, NANOMETRE, VISIBLE, WAVELENGTHS } from '../observer/standardObserver.ts';
import { BASIS_ENDS, BASIS_RANGE, basisAt, type SpectralFilter } from '../reflectance/spectralFilter.ts';

/**
 * The colour of light of a spectrum that a filter sends to the eye, for each of its bands by itself, over two shifts: a texture of
 * half floats, to be interpolated linearly between texels. Layers of rows × columns RGBA texels, row after row;
 * C_j is the linear sRGB (of N, see observerColor.ts) that band j alone shows:
 *
 *   layer 0: C_r, H    layer 1: C_g, 0    layer 2: C_b, 0    layer 3, in tables of four: C_x, 0
 *
 * Of three layers: for filters whose ultraviolet and infrared are what their basis ends at (`filterFromRgb` a colour); seen =
 * r C_r + g C_g + b C_b. Of four: for any filter, add x C_x, where x is its `uv` for D_out < 1 and its `ir` for D_out > 1: no eye sees both.
 * H is the luminance of a blackbody (`relativeLuminance`).
 */
export interface DopplerTable {
  readonly data: Uint16Array;
  readonly layers: 3 | 4;
  /** Along D_out, the shift from the filter to the eye: `columnOf`. */
  readonly columns: number;
  /** Along the temperature at which light is seen, filtered or not: `rowOf`. */
  readonly rows: number;
}

/** Beyond these D_out nothing that is seen comes from within `FLIP_THRESHOLD`: only `uv`, or only `ir`, and nothing more changes. */
export const SHIFT_LIMIT = VISIBLE[1] / VISIBLE[0];

/** Of x ≥ 0 on a scale that is nearly logarithmic around 1, has 0 and ∞ at its ends and costs no logarithm; and back. */
export const toUnitRatio = (x: number): number => (x === Number.POSITIVE_INFINITY ? 1 : x / (1 + x));
export const fromUnitRatio = (s: number): number => s / (1 - s);

const MAX_RATIO_OFFSET = toUnitRatio(SHIFT_LIMIT) - 0.5;

/** Column of a shift D_out, 0…columns − 1 in the middles of texels: linear in D/(1 + D); the middle one is D = 1. */
export const columnOf = ({ columns }: Pick<DopplerTable, 'columns'>, Dout: number): number =>
  (columns - 1) * Math.min(Math.max(0.5 + (toUnitRatio(Dout) - 0.5) / (2 * MAX_RATIO_OFFSET), 0), 1);

/** The shift of a column. */
export const shiftAt = (column: number, columns: number): number =>
  fromUnitRatio(0.5 + ((2 * column) / (columns - 1) - 1) * MAX_RATIO_OFFSET);

/** A row of a table: light as radiance [1/m] at each of `WAVELENGTH_RANGE`, and its H. */
export interface TableRow {
  readonly radiance: readonly number[];
  readonly H: number;
}

/** The table of the lights of its rows, of three layers or four. */
export function shiftedColorTable(lights: readonly TableRow[], layers: 3 | 4, columns: number): DopplerTable {
  const rows = lights.length;
  const data = new Uint16Array(4 * layers * rows * columns);
  const filters = Array.from({ length: columns }, (_, column) => shiftedBands(shiftAt(column, columns)));
  const found = new Float64Array(12);
  lights.forEach(({ radiance, H }, row) => {
    const light = observedLight(radiance);
    filters.forEach((filter, column) => {
      bandColors(light, filter, layers === 3, found);
      storeTexel(data, layers, row * columns + column, found, H);
    });
  });
  return { data, layers, columns, rows };
}

/** Linear sRGB of each nanometre that is seen, channel by channel, and their sums up to it. */
interface ObservedLight {
  readonly colors: readonly Float64Array[];
  readonly sums: readonly Float64Array[];
}

/** Linear sRGB of light of radiance 1 at each nanometre, channel by channel. */
export const OBSERVER_SRGB = [0, 1, 2].map(
  (k) => new Float64Array(WAVELENGTHS.map((wavelength) => toLinearSrgb(colorMatching(wavelength))[k] * NANOMETRE)),
);

function observedLight(radiance: readonly number[]): ObservedLight {
  const colors = OBSERVER_SRGB.map((channel) => channel.map((value, i) => value * radiance[i]));
  return { colors, sums: colors.map(runningSum) };
}

function runningSum(values: Float64Array): Float64Array {
  const sums = new Float64Array(values.length + 1);
  for (let i = 0; i < values.length; i++) sums[i + 1] = sums[i] + values[i];
  return sums;
}

/** The sum of the first `place` values, where a place of 2.5 means two and half of the third. */
function sumUpTo(sums: Float64Array, place: number): number {
  const within = Math.min(Math.max(place, 0), sums.length - 1);
  const i = Math.min(Math.floor(within), sums.length - 2);
  return sums[i] + (sums[i + 1] - sums[i]) * (within - i);
}

/** The bands as an eye sees them that meets their light shifted by D: where, counted in `WAVELENGTH_RANGE`, is what. */
interface ShiftedBands {
  /** Here the basis varies; before, it is `ENDS.uv`, after it `ENDS.ir`. */
  readonly from: number;
  readonly to: number;
  /** b_r and b_g at `from` … `to` − 1. */
  readonly red: Float64Array;
  readonly green: Float64Array;
  /** So many nanometres from the first are ultraviolet, and from `infrared` on infrared. */
  readonly ultraviolet: number;
  readonly infrared: number;
}

function shiftedBands(D: number): ShiftedBands {
  const count = WAVELENGTHS.length;
  const placeOf = (wavelength: number) => (wavelength / D - WAVELENGTHS[0]) / NANOMETRE;
  const [from, to] = BASIS_RANGE.map((end) => Math.min(Math.max(Math.ceil(placeOf(end)), 0), count));
  const basis = WAVELENGTHS.slice(from, to).map((wavelength) => basisAt(D * wavelength));
  return {
    from,
    to,
    red: new Float64Array(basis.map(([red]) => red)),
    green: new Float64Array(basis.map(([, green]) => green)),
    ultraviolet: placeOf(VISIBLE[0]) + 0.5,
    infrared: placeOf(VISIBLE[1]) + 0.5,
  };
}

/** Finds C_r, C_g, C_b and C_x, one after the other; `closed`: with C_x as it is by the ends of the basis already in the three. */
function bandColors({ colors, sums }: ObservedLight, bands: ShiftedBands, closed: boolean, found: Float64Array): void {
  const { from, to, red, green } = bands;
  for (let k = 0; k < 3; k++) {
    const values = colors[k];
    const total = sums[k][values.length];
    const uv = sumUpTo(sums[k], bands.ultraviolet);
    const ir = total - sumUpTo(sums[k], bands.infrared);
    const before = sums[k][from] - (closed ? 0 : uv);
    const after = total - sums[k][to] - (closed ? 0 : ir);
    let r = BASIS_ENDS.uv[0] * before + BASIS_ENDS.ir[0] * after;
    let g = BASIS_ENDS.uv[1] * before + BASIS_ENDS.ir[1] * after;
    for (let i = from; i < to; i++) {
      r += red[i - from] * values[i];
      g += green[i - from] * values[i];
    }
    found[k] = r;
    found[3 + k] = g;
    found[6 + k] = (closed ? total : total - uv - ir) - r - g;
    // One of them is 0.
    found[9 + k] = uv + ir;
  }
}

function storeTexel(data: Uint16Array, layers: number, texel: number, found: Float64Array, H: number): void {
  const layerSize = data.length / layers;
  for (let layer = 0; layer < layers; layer++) {
    const at = layer * layerSize + 4 * texel;
    for (let k = 0; k < 3; k++) data[at + k] = toHalf(found[3 * layer + k]);
    data[at + 3] = layer === 0 ? toHalf(H) : 0;
  }
}

/** What a GPU makes of the table: the linear sRGB of a filter at `row` and `column`, interpolated. */
export function tableColor(table: DopplerTable, row: number, column: number, { rgb, uv, ir }: SpectralFilter): Vec3 {
  const parts = [...rgb, column < (table.columns - 1) / 2 ? uv : ir].slice(0, table.layers);
  const texels = parts.map((_, layer) => tableTexel(table, layer, row, column));
  const channel = (k: number) => parts.reduce((sum, part, layer) => sum + part * texels[layer][k], 0);
  return [channel(0), channel(1), channel(2)];
}

/** The four numbers of a layer at `row` and `column`, interpolated linearly along both. */
export function tableTexel(
  { data, rows, columns }: DopplerTable,
  layer: number,
  row: number,
  column: number,
): number[] {
  const [i, j] = [Math.min(Math.floor(row), rows - 2), Math.min(Math.floor(column), columns - 2)];
  const [s, t] = [row - i, column - j];
  const texel = (di: number, dj: number, k: number) =>
    fromHalf(data[4 * ((layer * rows + i + di) * columns + j + dj) + k]);
  const alongRow = (di: number, k: number) => (1 - t) * texel(di, 0, k) + t * texel(di, 1, k);
  return [0, 1, 2, 3].map((k) => (1 - s) * alongRow(0, k) + s * alongRow(1, k));
}
