import { toHalf } from '../../math/half.ts';
import { colorOfSpectrum } from '../color/observerColor.ts';
import { WAVELENGTHS } from '../observer/standardObserver.ts';
import { DAYLIGHT, spectralRadiance, type ThermalSpectrum } from '../sources/lightSpectrum.ts';
import { logExpm1, logLuminance, SECOND_RADIATION } from '../sources/planck.ts';
import { type DopplerTable, fromUnitRatio, shiftedColorTable, toUnitRatio } from './dopplerTable.ts';

/** The temperature of the middle row [K]; that of `DAYLIGHT` is exactly the row at three quarters. */
export const MIDDLE_TEMPERATURE = DAYLIGHT.temperature / 3;

const ROWS = 129;
/** 4 nm apart in the middle of the visible. Odd, so that D = 1 is a column. */
const COLUMNS = 193;

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
export const thermalTable = (layers: 3 | 4, columns = COLUMNS, rows = ROWS): DopplerTable =>
  shiftedColorTable(
    temperatures(rows).map((temperature) => {
      const spectrum: ThermalSpectrum = { kind: 'thermal', temperature };
      const radiance = WAVELENGTHS.map((wavelength) => spectralRadiance(spectrum, wavelength));
      return { radiance, H: luminanceShape(temperature) };
    }),
    layers,
    columns,
  );

/** A texture of one row of RGBA half floats over `rowOf`: the linear sRGB of a blackbody at luminance 1, and H. */
export interface BlackbodyCurve {
  readonly data: Uint16Array;
  readonly rows: number;
}

/** The colours of unfiltered blackbodies (stars, embers, visible lights) at T·D: one texel instead of three. */
export function blackbodyCurve(rows = ROWS): BlackbodyCurve {
  const texels = temperatures(rows).map((temperature) => [
    ...colorOfSpectrum({ kind: 'thermal', temperature }),
    luminanceShape(temperature),
  ]);
  return { data: Uint16Array.from(texels.flat(), toHalf), rows };
}

/** θ [K] of `blackbodyLuminance`: hc/(k_B · 600 nm), near the middle of the visible light of warm blackbodies, so that H varies little. */
export const LUMINANCE_THETA = SECOND_RADIATION / 600e-9;

/** Upper limit of H for half floats; reached below about 200 K, where a blackbody is e^−100 times as bright as daylight. */
const MAX_H = 60_000;

/** H(T) = Y(T)/Y(6504 K) · (e^{θ/T} − 1)/(e^{θ/6504 K} − 1): 0.58 … 1.3 above 700 K, 12 at 400 K. */
export function luminanceShape(T: number): number {
  return Math.exp(Math.min(logShape(T) - DAYLIGHT_LOG_SHAPE, Math.log(MAX_H)));
}

const logShape = (T: number): number => logLuminance(T) + logExpm1(LUMINANCE_THETA / T);
const DAYLIGHT_LOG_SHAPE = logShape(DAYLIGHT.temperature);

/**
 * Y(T)/Y(6504 K), the luminance of a blackbody of T [K], from the table's H at T: H (e^{θ/6504 K} − 1)/(e^{θ/T} − 1).
 * A light of T shifted by D keeps the share Y(TD)/(Y(T) D⁴) of its luminance, besides the D⁴ of beaming.
 */
export const blackbodyLuminance = (H: number, T: number): number =>
  (H * Math.expm1(LUMINANCE_THETA / DAYLIGHT.temperature)) / Math.expm1(LUMINANCE_THETA / T);
