import { colorOfSpectrum } from '../color/observerColor.ts';
import { WAVELENGTHS } from '../observer/standardObserver.ts';
import { DAYLIGHT, spectralRadiance, type ThermalSpectrum } from '../sources/lightSpectrum.ts';
import { logExpm1, logLuminance, SECOND_RADIATION } from '../sources/planck.ts';
import { type DopplerTable, fromUnitRatio, shiftedColorTable, toUnitRatio } from './dopplerTable.ts';

/** The temperature of the middle row [K]; that of `DAYLIGHT` is exactly the row at three quarters. */
export const MIDDLE_TEMPERATURE = DAYLIGHT.temperature / 3;

const ROWS = 257;
/** 2.4 nm apart in the middle of the visible. Odd, so that D = 1 is a column. */
const COLUMNS = 321;

/** Row of a temperature T ≥ 0 [K], 0…rows − 1 at texel centres: linear in T/(T + `MIDDLE_TEMPERATURE`). */
export const rowOf = ({ rows }: { readonly rows: number }, T: number): number =>
  (rows - 1) * toUnitRatio(T / MIDDLE_TEMPERATURE);

/** The temperatures of the rows [K], clamped to 50 … 1e12 K: beyond these (Wien's and Rayleigh–Jeans' limits) colours do not change. */
const temperatures = (rows: number): number[] =>
  Array.from({ length: rows }, (_, row) =>
    Math.min(Math.max(MIDDLE_TEMPERATURE * fromUnitRatio(row / (rows - 1)), 50), 1e12),
  );

/**
 * The table of blackbodies over the observed temperature T·D_in·D_out (`rowOf`) and the shift D_out (`columnOf`), at luminance 1:
 * white shows `colorOfSpectrum` of the blackbody; at 6504 K and D = 1, C_r, C_g and C_b are the identity. Four layers if some filter has its own `uv` or `ir`.
 * docs/physics.md §7.5.
 */
export function thermalTable(layers: 3 | 4, columns = COLUMNS, rows = ROWS): DopplerTable {
  const shapes = rowShapes(rows);
  return shiftedColorTable(
    temperatures(rows).map((temperature, i) => {
      const spectrum: ThermalSpectrum = { kind: 'thermal', temperature };
      const radiance = WAVELENGTHS.map((wavelength) => spectralRadiance(spectrum, wavelength));
      return { radiance, G: shapes[i] };
    }),
    layers,
    columns,
  );
}

/** G of the rows, by their own temperatures, also where colours do not change any more. */
const rowShapes = (rows: number): readonly number[] =>
  Array.from({ length: rows }, (_, row) => luminanceShape(MIDDLE_TEMPERATURE * fromUnitRatio(row / (rows - 1))));

/** The colours of unfiltered blackbodies over `rowOf`: four numbers a row, linear sRGB at luminance 1 and G. */
export interface BlackbodyCurve {
  readonly values: Float64Array;
  readonly rows: number;
}

/** For stars, embers and visible lights at T·D: linear between rows. */
export function blackbodyCurve(rows = 2 * ROWS - 1): BlackbodyCurve {
  const shapes = rowShapes(rows);
  const texels = temperatures(rows).map((temperature, i) => [
    ...colorOfSpectrum({ kind: 'thermal', temperature }),
    shapes[i],
  ]);
  return { values: Float64Array.from(texels.flat()), rows };
}

/** θ [K] of `blackbodyLuminance`: hc/(k_B · 600 nm), near the middle of the visible light of warm blackbodies, so that G varies little. */
export const LUMINANCE_THETA = SECOND_RADIATION / 600e-9;

/** Colder than this a blackbody is e^−850 times as bright as daylight [K]. */
export const DARK_TEMPERATURE = 20;

/**
 * G(T) = T/(T + T₀) · ln [Y(T)/Y(6504 K) · (e^{θ/T} − 1)/(e^{θ/6504 K} − 1)] with T₀ = `MIDDLE_TEMPERATURE`: finite at 0 and ∞, and smooth enough
 * to be interpolated between rows.
 */
export function luminanceShape(T: number): number {
  const within = Math.min(Math.max(T, 1), 1e12);
  return (logShape(within) - DAYLIGHT_LOG_SHAPE) * toUnitRatio(within / MIDDLE_TEMPERATURE);
}

const logShape = (T: number): number => logLuminance(T) + logExpm1(LUMINANCE_THETA / T);
const DAYLIGHT_LOG_SHAPE = logShape(DAYLIGHT.temperature);

/**
 * Y(T)/Y(6504 K), the luminance of a blackbody of T [K], from G at T: e^{G (1 + T₀/T)} (e^{θ/6504 K} − 1)/(e^{θ/T} − 1).
 * A light of T shifted by D keeps the share Y(TD)/(Y(T) D⁴) of its luminance, besides the D⁴ of beaming.
 */
export function blackbodyLuminance(G: number, T: number): number {
  const inverse = 1 / Math.max(T, DARK_TEMPERATURE);
  const log = G * (1 + MIDDLE_TEMPERATURE * inverse) - logExpm1(LUMINANCE_THETA * inverse);
  return Math.exp(log) * Math.expm1(LUMINANCE_THETA / DAYLIGHT.temperature);
}
