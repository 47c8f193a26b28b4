import { toHalf } from '../../math/half.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { NANOMETRE, WAVELENGTHS } from '../observer/standardObserver.ts';
import { basisAt, reflectanceAt, type SpectralFilter } from '../reflectance/spectralFilter.ts';
import { meanRadiance, type SampledSpectrum, spectralRadiance } from '../sources/lightSpectrum.ts';
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

const BEYOND: SpectralFilter = { rgb: [0, 0, 0], uv: 1, ir: 1 };

/** The linear sRGB channels of a blackbody of luminance 1 at every nanometre. */
function observedBlackbody(temperature: number): readonly Float64Array[] {
  const spectrum = { kind: 'thermal', temperature } as const;
  const radiance = Float64Array.from(WAVELENGTHS, (wavelength) => spectralRadiance(spectrum, wavelength));
  return OBSERVER_SRGB.map((channel) => channel.map((value, i) => value * radiance[i]));
}

function sumOf(a: Float64Array, b: Float64Array): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
  return sum;
}

/**
 * C_rg, C_gb and C_br of a blackbody observed at T [K] and luminance 1, with both filters observed at the shift D, as for light reflected by a surface at rest.
 * Because Σ_j C_ij = C_i, the observed colour is Σ a_i k_i C_i − Σ (a_i − a_j)(k_i − k_j) C_ij over these three pairs; the second sum is 0 if either filter is neutral.
 */
export function bandOverlaps(T: number, D: number, layers: 3 | 4): readonly [rg: Vec3, gb: Vec3, br: Vec3] {
  const light = observedBlackbody(T);
  const [surface, bands] = [bandTransmission(D, layers), bandTransmission(D, 3)];
  const overlap = (i: number, j: number): Vec3 => {
    const both = surface[i].map((value, n) => value * bands[j][n]);
    return [sumOf(both, light[0]), sumOf(both, light[1]), sumOf(both, light[2])];
  };
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
 * `bands`: `bandTransmission` of the surface and of the light. Layer after layer.
 */
export function filteredBlackbodyAtRest(
  { temperature, filter }: FilteredBlackbody,
  D: number,
  bands: { readonly surface: readonly Float64Array[]; readonly light: readonly Float64Array[] },
): readonly Vec3[] {
  const through = throughFilter(filter, bands.light);
  const light = observedBlackbody(temperature * D).map((channel) => channel.map((value, n) => value * through[n]));
  return bands.surface.map((band) => [sumOf(band, light[0]), sumOf(band, light[1]), sumOf(band, light[2])]);
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
  const radiance = WAVELENGTHS.map((wavelength) => D * meanRadiance(spectrum, D * wavelength, D * NANOMETRE));
  const [red, green, blue] = OBSERVER_SRGB.map((channel) => channel.map((value, n) => value * radiance[n]));
  return surface.map((band) => [sumOf(band, red), sumOf(band, green), sumOf(band, blue)]);
}

const throughFilter = ([r, g, b]: Vec3, [red, green, blue]: readonly Float64Array[]): Float64Array =>
  red.map((value, n) => r * value + g * green[n] + b * blue[n]);

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
  const surfaces = shifts.map((D) => bandTransmission(D, layers));
  const luminanceShapes = shapeChannels(
    shifts.map((D) => luminanceShape(temperature * D)),
    secondDifference,
  );
  shifts.forEach((D, row) => {
    const through = throughFilter(filter, bandTransmission(D, 3));
    const light = observedBlackbody(temperature * D).map((channel) => channel.map((value, n) => value * through[n]));
    light.forEach((channel, k) => {
      const total = sumOf(ONES, channel);
      surfaces.forEach((parts, column) => {
        const at = (layer: number) => 4 * ((layer * steps + row) * steps + column);
        const [r, g, x] = [parts[0], parts[1], parts[3]].map((part) => (part ? sumOf(part, channel) : 0));
        data[at(0) + k] = toHalf(r);
        data[at(1) + k] = toHalf(g);
        data[at(2) + k] = toHalf(total - r - g - x);
        if (layers === 4) data[at(3) + k] = toHalf(x);
        for (let layer = 0; layer < 3; layer++) data[at(layer) + 3] = toHalf(luminanceShapes[row][layer]);
      });
    });
  });
  return { data, layers, columns: steps, rows: steps };
}
