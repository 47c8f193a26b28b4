import { fromHalf, toHalf } from '../../math/half.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { toLinearSrgb } from '../color/observerColor.ts';
import { colorMatching, NANOMETRE, VISIBLE, WAVELENGTHS } from '../observer/standardObserver.ts';
import { BASIS_ENDS, BASIS_RANGE, basisAt, type SpectralFilter } from '../reflectance/spectralFilter.ts';

/**
 * The observed colour of each band of a filter in a light, over two parameters: a texture of half floats with linear
 * interpolation between texels (docs/physics.md §7.5). Layers of rows × columns RGBA texels, row after row;
 * C_j is the linear sRGB (by N, see observerColor.ts) that band j alone shows:
 *
 *   layer 0: C_r, G    layer 1: C_g, G′    layer 2: C_b, δ²G    layer 3, in tables of four: C_x, 0
 *
 * Three layers: for filters whose `uv` and `ir` are the values at the ends of the basis (`filterFromRgb` of a colour); the observed colour is
 * r C_r + g C_g + b C_b. Four layers: for any filter, plus x C_x, where x is its `uv` for D_out < 1 and its `ir` for D_out > 1 (never both are visible).
 * G + G′ gives the luminance of a blackbody (`blackbodyLuminance`): two halves, which together have the precision of 22 bits, and δ²G, its second difference
 * from row to row, with which `tableShape` interpolates it.
 */
export interface DopplerTable {
  readonly data: Uint16Array;
  readonly layers: 3 | 4;
  /** Along D_out, the shift from the filter to the observer: `columnOf`. */
  readonly columns: number;
  /** Along the temperature at which the light is observed: `rowOf`. */
  readonly rows: number;
}

/** For D_out beyond this, or below its reciprocal, all visible light comes from outside `VISIBLE`: only `uv` or only `ir` counts, and nothing changes any more. */
export const SHIFT_LIMIT = VISIBLE[1] / VISIBLE[0];

/** Maps 0 … ∞ to 0 … 1: nearly logarithmic around 1, without the cost of a logarithm; and its inverse. */
export const toUnitRatio = (x: number): number => (x === Number.POSITIVE_INFINITY ? 1 : x / (1 + x));
export const fromUnitRatio = (s: number): number => s / (1 - s);

const MAX_RATIO_OFFSET = toUnitRatio(SHIFT_LIMIT) - 0.5;

/** Column of a shift D_out, 0…columns − 1 at texel centres: linear in D/(1 + D); the middle column is D = 1. */
export const columnOf = ({ columns }: Pick<DopplerTable, 'columns'>, Dout: number): number =>
  (columns - 1) * Math.min(Math.max(0.5 + (toUnitRatio(Dout) - 0.5) / (2 * MAX_RATIO_OFFSET), 0), 1);

/** The shift of a column. */
export const shiftAt = (column: number, columns: number): number =>
  fromUnitRatio(0.5 + ((2 * column) / (columns - 1) - 1) * MAX_RATIO_OFFSET);

/** A row of a table: the radiance of its light [1/m] at each of `WAVELENGTHS`, and its G. */
export interface TableRow {
  readonly radiance: readonly number[];
  readonly G: number;
}

/** The table with one light per row, of three or four layers. */
export function shiftedColorTable(lights: readonly TableRow[], layers: 3 | 4, columns: number): DopplerTable {
  const rows = lights.length;
  const data = new Uint16Array(4 * layers * rows * columns);
  const filters = Array.from({ length: columns }, (_, column) => shiftedBands(shiftAt(column, columns)));
  const found = new Float64Array(12);
  const shapes = shapeChannels(
    lights.map(({ G }) => G),
    secondDifference,
  );
  lights.forEach(({ radiance }, row) => {
    const light = observedLight(radiance);
    filters.forEach((filter, column) => {
      bandColors(light, filter, layers === 3, found);
      storeTexel(data, layers, row * columns + column, found, shapes[row]);
    });
  });
  return { data, layers, columns, rows };
}

/** Observed linear sRGB of each nanometre, by channel, and the running sums. */
interface ObservedLight {
  readonly colors: readonly Float64Array[];
  readonly sums: readonly Float64Array[];
}

/** Linear sRGB of light of radiance 1 at each nanometre, by channel. */
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

/** The sum of the first `place` values; 2.5 means the first two and half of the third. */
function sumUpTo(sums: Float64Array, place: number): number {
  const within = Math.min(Math.max(place, 0), sums.length - 1);
  const i = Math.min(Math.floor(within), sums.length - 2);
  return sums[i] + (sums[i + 1] - sums[i]) * (within - i);
}

/** The bands of a filter as observed with the shift D; indices count in `WAVELENGTHS`. */
interface ShiftedBands {
  /** The basis varies between `from` and `to`; before, it is `BASIS_ENDS.uv`, after, `BASIS_ENDS.ir`. */
  readonly from: number;
  readonly to: number;
  /** b_r and b_g at `from` … `to` − 1. */
  readonly red: Float64Array;
  readonly green: Float64Array;
  /** The first `ultraviolet` nanometres are ultraviolet, those from `infrared` on are infrared. */
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

/** Writes C_r, C_g, C_b and C_x to `found`; `closed`: the ultraviolet and infrared are included in the first three, by the ends of the basis. */
function bandColors({ colors, sums }: ObservedLight, bands: ShiftedBands, closed: boolean, found: Float64Array): void {
  const { from, to } = bands;
  sumBands(colors, bands, found);
  for (let k = 0; k < 3; k++) {
    const total = sums[k][colors[k].length];
    const uv = sumUpTo(sums[k], bands.ultraviolet);
    const ir = total - sumUpTo(sums[k], bands.infrared);
    const before = sums[k][from] - (closed ? 0 : uv);
    const after = total - sums[k][to] - (closed ? 0 : ir);
    const r = found[k] + BASIS_ENDS.uv[0] * before + BASIS_ENDS.ir[0] * after;
    const g = found[3 + k] + BASIS_ENDS.uv[1] * before + BASIS_ENDS.ir[1] * after;
    found[k] = r;
    found[3 + k] = g;
    found[6 + k] = (closed ? total : total - uv - ir) - r - g;
    // One of the two is 0.
    found[9 + k] = uv + ir;
  }
}

/** Writes what the red and the green band show where the basis varies: six sums in one pass, which take most of a table's time. */
function sumBands([X, Y, Z]: readonly Float64Array[], { from, red, green }: ShiftedBands, found: Float64Array): void {
  let redX = 0;
  let redY = 0;
  let redZ = 0;
  let greenX = 0;
  let greenY = 0;
  let greenZ = 0;
  for (let i = 0; i < red.length; i++) {
    const r = red[i];
    const g = green[i];
    const x = X[from + i];
    const y = Y[from + i];
    const z = Z[from + i];
    redX += r * x;
    redY += r * y;
    redZ += r * z;
    greenX += g * x;
    greenY += g * y;
    greenZ += g * z;
  }
  found[0] = redX;
  found[1] = redY;
  found[2] = redZ;
  found[3] = greenX;
  found[4] = greenY;
  found[5] = greenZ;
}

/** The fourth channels of the first three layers, for each of a row of values of G. */
export function shapeChannels(
  values: readonly number[],
  correction: (before: number, value: number, after: number) => number,
): readonly Vec3[] {
  return values.map((G, i) => {
    const high = fromHalf(toHalf(G));
    return [high, G - high, correction(values[i - 1] ?? G, G, values[i + 1] ?? G)];
  });
}

export const secondDifference = (before: number, value: number, after: number): number => before - 2 * value + after;

function storeTexel(data: Uint16Array, layers: number, texel: number, found: Float64Array, shape: Vec3): void {
  const layerSize = data.length / layers;
  for (let layer = 0; layer < layers; layer++) {
    const at = layer * layerSize + 4 * texel;
    for (let k = 0; k < 3; k++) data[at + k] = toHalf(found[3 * layer + k]);
    data[at + 3] = layer < 3 ? toHalf(shape[layer]) : 0;
  }
}

/** The linear sRGB of a filter at `row` and `column`, interpolated as a GPU does. */
export function tableColor(table: DopplerTable, row: number, column: number, { rgb, uv, ir }: SpectralFilter): Vec3 {
  const parts = [...rgb, column < (table.columns - 1) / 2 ? uv : ir].slice(0, table.layers);
  const texels = parts.map((_, layer) => tableTexel(table, layer, row, column));
  const channel = (k: number) => parts.reduce((sum, part, layer) => sum + part * texels[layer][k], 0);
  return [channel(0), channel(1), channel(2)];
}

/** G at `row`, interpolated by a parabola. */
export function tableShape(table: DopplerTable, row: number): number {
  const [high, low, curvature] = [0, 1, 2].map((layer) => interpolated(table, layer, row, 0, 3));
  const fraction = row - Math.floor(row);
  return high + low - (fraction * (1 - fraction) * curvature) / 2;
}

/** The colour of a layer at `row` and `column`, bilinearly interpolated. */
export const tableTexel = (table: DopplerTable, layer: number, row: number, column: number): Vec3 => [
  interpolated(table, layer, row, column, 0),
  interpolated(table, layer, row, column, 1),
  interpolated(table, layer, row, column, 2),
];

/** A channel of a layer at `row` and `column`, bilinearly interpolated. */
function interpolated(
  { data, rows, columns }: DopplerTable,
  layer: number,
  row: number,
  column: number,
  channel: number,
): number {
  const i = Math.min(Math.floor(row), rows - 2);
  const j = Math.min(Math.floor(column), columns - 2);
  const [s, t] = [row - i, column - j];
  const first = 4 * ((layer * rows + i) * columns + j) + channel;
  const second = first + 4 * columns;
  const [a, b] = [fromHalf(data[first]), fromHalf(data[first + 4])];
  const [c, d] = [fromHalf(data[second]), fromHalf(data[second + 4])];
  return (1 - s) * ((1 - t) * a + t * b) + s * ((1 - t) * c + t * d);
}
