import { toHalf } from '../../math/half.ts';
import { scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { NANOMETRE, WAVELENGTHS } from '../observer/standardObserver.ts';
import { basisAt, reflectanceAt, type SpectralFilter } from '../reflectance/spectralFilter.ts';
import { meanRadiances, type SampledSpectrum, spectralRadiance } from '../sources/lightSpectrum.ts';
import { type DopplerTable, OBSERVER_SRGB, secondDifference, shapeChannels, shiftAt } from './dopplerTable.ts';
import { luminanceShape } from './thermalTable.ts';

/*
 * The product of two filters, of a light and of a surface, is not a filter: Σ k_j b_j(D λ) · Σ a_i b_i(D_out λ). The observed colour of a blackbody through
 * both is Σ k_j a_i C_ij, with C_ij the linear sRGB of the light that passes band i of the one and band j of the other. docs/physics.md §7.6.
 */

/** Transmission of each band of a filter observed with the shift D, at every nanometre; the fourth layer is the part outside the visible (dopplerTable.ts). */
export function bandTransmission(D: number, layers: 3 | 4): readonly Float64Array[] {
  const bands = Array.from({ length: layers }, () => new Float64Array(WAVELENGTHS.length));
  WAVELENGTHS.forEach((wavelength, n) => {
    const basis = basisAt(D * wavelength);
    const beyond = layers === 4 ? reflectanceAt(BEYOND, D * wavelength, D * NANOMETRE) : 0;
    for (let i = 0; i < 3; i++) bands[i][n] = basis[i] * (1 - beyond);
    if (layers === 4) bands[3][n] = beyond;
  });
  return bands;
}

/** Transmissions of the bands of a surface's filter and of a light's, which has three, at the same shift. */
export interface PairedBands {
  readonly surface: readonly Float64Array[];
  readonly light: readonly Float64Array[];
}

/** `bandTransmission` of a surface and of a light. */
export function pairedBands(D: number, layers: 3 | 4): PairedBands {
  const surface = bandTransmission(D, layers);
  return { surface, light: layers === 3 ? surface : bandTransmission(D, 3) };
}

const BEYOND: SpectralFilter = { rgb: [0, 0, 0], uv: 1, ir: 1 };

/** Radiance [1/m] of a blackbody of luminance 1 at every nanometre. */
function blackbodyRadiance(temperature: number): Float64Array {
  const spectrum = { kind: 'thermal', temperature } as const;
  const radiance = new Float64Array(WAVELENGTHS.length);
  for (let n = 0; n < radiance.length; n++) radiance[n] = spectralRadiance(spectrum, WAVELENGTHS[n]);
  return radiance;
}

function product(a: Float64Array, b: Float64Array): Float64Array {
  const products = new Float64Array(a.length);
  for (let n = 0; n < a.length; n++) products[n] = a[n] * b[n];
  return products;
}

/** Linear sRGB of a light, given at every nanometre, that passes a band. */
function colorThrough(band: Float64Array, light: Float64Array): Vec3 {
  const [R, G, B] = OBSERVER_SRGB;
  let [r, g, b] = [0, 0, 0];
  for (let n = 0; n < light.length; n++) {
    const passed = band[n] * light[n];
    r += passed * R[n];
    g += passed * G[n];
    b += passed * B[n];
  }
  return [r, g, b];
}

/**
 * C_rg, C_gb and C_br of a blackbody observed at T [K] and luminance 1, with the bands of both filters at one shift, as for light reflected by a surface at rest.
 * Because Σ_j C_ij = C_i, the observed colour is Σ a_i k_i C_i − Σ (a_i − a_j)(k_i − k_j) C_ij over these three pairs; the second sum is 0 if either filter is neutral.
 */
export function bandOverlaps(T: number, { surface, light }: PairedBands): readonly [rg: Vec3, gb: Vec3, br: Vec3] {
  const radiance = blackbodyRadiance(T);
  const overlap = (i: number, j: number): Vec3 => colorThrough(product(surface[i], light[j]), radiance);
  return [overlap(0, 1), overlap(1, 2), overlap(2, 0)];
}

const ONES = new Float64Array(WAVELENGTHS.length).fill(1);

/** A blackbody behind a filter: its temperature at rest [K] and k. */
export interface FilteredBlackbody {
  readonly temperature: number;
  readonly filter: Vec3;
}

/**
 * The observed colour of one coloured light reflected by a surface at rest, for each band of the surface's filter, both observed with the shift D.
 * `bands`: at that shift. Layer after layer.
 */
export function filteredBlackbodyAtRest(
  { temperature, filter }: FilteredBlackbody,
  D: number,
  bands: PairedBands,
): readonly Vec3[] {
  const light = product(blackbodyRadiance(temperature * D), throughFilter(filter, bands.light));
  return bands.surface.map((band) => colorThrough(band, light));
}

/**
 * The observed colour of light of a sampled spectrum reflected by a surface at rest, for each band of the surface's filter (`bandTransmission`), both observed
 * with the shift D, without the D⁴ of beaming. Linear sRGB, layer after layer, of light of luminance 1 at rest.
 */
export function sampledSpectrumAtRest(
  spectrum: SampledSpectrum,
  D: number,
  surface: readonly Float64Array[],
): readonly Vec3[] {
  const radiance = new Float64Array(WAVELENGTHS.length);
  meanRadiances(spectrum, D * WAVELENGTHS[0], D * NANOMETRE, radiance);
  return surface.map((band) => scale(colorThrough(band, radiance), D));
}

function throughFilter([r, g, b]: Vec3, [red, green, blue]: readonly Float64Array[]): Float64Array {
  const through = new Float64Array(red.length);
  for (let n = 0; n < red.length; n++) through[n] = r * red[n] + g * green[n] + b * blue[n];
  return through;
}

/** Steps of the table: 8 nm apart in the middle of the visible, with an error of 0.1 % of white's luminance. Odd, so that D = 1 is a step. */
const TABLE_STEPS = 97;

/**
 * The observed colour of one coloured light through each band of a surface's filter, Σ_j k_j C_ij: as the table of blackbodies, but with the rows over the shift
 * D = D_in D_out from the light to the observer, and the columns over D_out, both by `columnOf`.
 */
export function filteredBlackbodyTable(
  { temperature, filter }: FilteredBlackbody,
  layers: 3 | 4,
  steps = TABLE_STEPS,
): DopplerTable {
  const data = new Uint16Array(4 * layers * steps * steps);
  const shifts = Array.from({ length: steps }, (_, step) => shiftAt(step, steps));
  const bands = shifts.map((D) => pairedBands(D, layers));
  const luminanceShapes = shapeChannels(
    shifts.map((D) => luminanceShape(temperature * D)),
    secondDifference,
  );
  shifts.forEach((D, row) => {
    const light = product(blackbodyRadiance(temperature * D), throughFilter(filter, bands[row].light));
    const total = colorThrough(ONES, light);
    const shape = luminanceShapes[row].map(toHalf);
    const at = (layer: number, column: number): number => 4 * ((layer * steps + row) * steps + column);
    bands.forEach(({ surface }, column) => {
      for (let layer = 0; layer < 3; layer++) data[at(layer, column) + 3] = shape[layer];
      const r = colorThrough(surface[0], light);
      const g = colorThrough(surface[1], light);
      const x = layers === 4 ? colorThrough(surface[3], light) : ZERO;
      for (let k = 0; k < 3; k++) {
        data[at(0, column) + k] = toHalf(r[k]);
        data[at(1, column) + k] = toHalf(g[k]);
        data[at(2, column) + k] = toHalf(total[k] - r[k] - g[k] - x[k]);
        if (layers === 4) data[at(3, column) + k] = toHalf(x[k]);
      }
    });
  });
  return { data, layers, columns: steps, rows: steps };
}
