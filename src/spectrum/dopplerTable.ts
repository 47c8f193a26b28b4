import { fromHalf, toHalf } from '../math/half.ts';
import { dot, type Vec3 } from '../math/vec3.ts';
import { BASIS_RANGE, type Bands, basisAt, ENDS } from './bands.ts';
import { colorMatching, NANOMETRE, VISIBLE, WAVELENGTHS } from './cie1931.ts';
import { toLinearSrgb } from './observerColor.ts';

/**
 * The colour of light of a spectrum that a filter of five bands sends to the eye, for each band by itself, over two shifts: a texture of
 * half floats, to be interpolated linearly between texels. Four layers of rows × columns RGBA texels, row after row;
 * C_j is the linear sRGB (of N, see observerColor.ts) that band j alone shows, C_uv = (u, v, w):
 *
 *   layer 0: C_r, H    layer 1: C_g, u    layer 2: C_b, v    layer 3: C_ir, w
 *
 * C_r, C_g and C_b have in their own ultraviolet and infrared what the basis ends at (`ENDS`), so for a filter without values of its own
 * three layers are all: seen = r C_r + g C_g + b C_b. Else add C_uv (uv − ENDS.uv·rgb) + C_ir (ir − ENDS.ir·rgb).
 * H is the luminance of a blackbody (`luminanceOf`), and 0 in the table of a sampled spectrum.
 */
export interface DopplerTable {
  readonly data: Uint16Array;
  /** Along D_out, the shift from the filter to the eye: `columnOf`. */
  readonly columns: number;
  /** Along what light is seen, filtered or not: `rowOf` a temperature, `shiftRowOf` a sampled spectrum's whole shift. */
  readonly rows: number;
}

/** Beyond these D_out nothing that is seen comes from within `VISIBLE`: only `uv`, or only `ir`, and nothing more changes. */
export const SHIFT_LIMIT = (VISIBLE[1] + NANOMETRE / 2) / (VISIBLE[0] - NANOMETRE / 2);

/** 4 nm between two columns in the middle of what an eye sees. Odd, so that D = 1 is one. */
export const COLUMNS = 193;

/** Of x ≥ 0 on a scale that is nearly logarithmic around 1, has 0 and ∞ at its ends and costs no logarithm; and back. */
export const ratio = (x: number): number => (x === Number.POSITIVE_INFINITY ? 1 : x / (1 + x));
export const fromRatio = (s: number): number => s / (1 - s);

const FARTHEST = ratio(SHIFT_LIMIT) - 0.5;

/** Column of a shift D_out, 0…columns − 1 in the middles of texels: linear in D/(1 + D); the middle one is D = 1. */
export const columnOf = ({ columns }: DopplerTable, Dout: number): number =>
  (columns - 1) * Math.min(Math.max(0.5 + (ratio(Dout) - 0.5) / (2 * FARTHEST), 0), 1);

const shiftAt = (column: number, columns: number): number =>
  fromRatio(0.5 + ((2 * column) / (columns - 1) - 1) * FARTHEST);

/** A row of a table: light as radiance [1/m] at each of `WAVELENGTHS`, and its H. */
export interface TableRow {
  readonly radiance: readonly number[];
  readonly H: number;
}

/** The table of the lights of its rows. */
export function doppleredColors(lights: readonly TableRow[], columns: number): DopplerTable {
  const rows = lights.length;
  const data = new Uint16Array(16 * rows * columns);
  const filters = Array.from({ length: columns }, (_, column) => shiftedBands(shiftAt(column, columns)));
  lights.forEach(({ radiance, H }, row) => {
    const light = seenLight(radiance);
    filters.forEach((filter, column) => {
      store(data, rows * columns, row * columns + column, bandColors(light, filter), H);
    });
  });
  return { data, columns, rows };
}

/** Linear sRGB of each nanometre that is seen, channel by channel, and their sums up to it. */
interface SeenLight {
  readonly colors: readonly Float64Array[];
  readonly sums: readonly Float64Array[];
}

const OBSERVER = WAVELENGTHS.map((wavelength) => toLinearSrgb(colorMatching(wavelength)));

function seenLight(radiance: readonly number[]): SeenLight {
  const colors = [0, 1, 2].map((k) => Float64Array.from(OBSERVER, (rgb, i) => rgb[k] * radiance[i] * NANOMETRE));
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

/** The bands as an eye sees them that meets their light shifted by D: where, counted in `WAVELENGTHS`, is what. */
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
  const placeOf = (wavelength: number) => (wavelength / D - VISIBLE[0]) / NANOMETRE;
  const [from, to] = BASIS_RANGE.map((end) => Math.min(Math.max(Math.ceil(placeOf(end)), 0), count));
  const basis = WAVELENGTHS.slice(from, to).map((wavelength) => basisAt(D * wavelength));
  return {
    from,
    to,
    red: Float64Array.from(basis, ([red]) => red),
    green: Float64Array.from(basis, ([, green]) => green),
    ultraviolet: placeOf(VISIBLE[0]) + 0.5,
    infrared: placeOf(VISIBLE[1]) + 0.5,
  };
}

/** C_r, C_g, C_b, C_uv, C_ir, one after the other. */
function bandColors({ colors, sums }: SeenLight, bands: ShiftedBands): Float64Array {
  const { from, to, red, green } = bands;
  const found = new Float64Array(15);
  for (let k = 0; k < 3; k++) {
    const values = colors[k];
    const all = sums[k][values.length];
    const before = sums[k][from];
    const after = all - sums[k][to];
    let [r, g] = [ENDS.uv[0] * before + ENDS.ir[0] * after, ENDS.uv[1] * before + ENDS.ir[1] * after];
    for (let i = from; i < to; i++) {
      r += red[i - from] * values[i];
      g += green[i - from] * values[i];
    }
    found[k] = r;
    found[3 + k] = g;
    found[6 + k] = all - r - g;
    found[9 + k] = sumUpTo(sums[k], bands.ultraviolet);
    found[12 + k] = all - sumUpTo(sums[k], bands.infrared);
  }
  return found;
}

function store(data: Uint16Array, layerSize: number, texel: number, found: Float64Array, H: number): void {
  for (let layer = 0; layer < 4; layer++) {
    const at = 4 * (layer * layerSize + texel);
    for (let k = 0; k < 3; k++) data[at + k] = toHalf(found[layer < 3 ? 3 * layer + k : 12 + k]);
    data[at + 3] = toHalf(layer === 0 ? H : found[8 + layer]);
  }
}

/** What a GPU makes of the table: the linear sRGB of a filter at `row` and `column`, interpolated. */
export function tableColor(table: DopplerTable, row: number, column: number, { rgb, uv, ir }: Bands): Vec3 {
  const [red, green, blue, infrared] = [0, 1, 2, 3].map((layer) => tableTexel(table, layer, row, column));
  const ultraviolet = [green[3], blue[3], infrared[3]];
  const moreUv = uv - dot(ENDS.uv, rgb);
  const moreIr = ir - dot(ENDS.ir, rgb);
  const channel = (k: number) =>
    rgb[0] * red[k] + rgb[1] * green[k] + rgb[2] * blue[k] + moreUv * ultraviolet[k] + moreIr * infrared[k];
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
