/**
 * Colour: the CIE 1931 observer, spectra of lights and surfaces, what a Doppler shift makes of them, tone curves.
 * Wavelengths in metres, colours linear sRGB with 6504 K as white.
 *
 * @module slowlight/spectrum
 */

export { blackbodyColor, glowColor } from './color/blackbodyColor.ts';
export { lightFilter } from './color/lightFilter.ts';
export { colorOfSpectrum, LUMINANCE_WEIGHTS, observedColor, toLinearSrgb } from './color/observerColor.ts';
export { P3_TO_XYZ, SRGB_TO_P3, SRGB_TO_XYZ, XYZ_TO_P3, XYZ_TO_SRGB } from './display/rgbSpaces.ts';
export { type ToneMapping, toneMap } from './display/toneMap.ts';
export { dopplerTint } from './doppler/dopplerTint.ts';
export { linearSpectrumShift, twoWavelengthShift } from './doppler/historicalShifts.ts';
export type { FalseColorQuantity, FalseColorScale, ValueRange } from './falseColor/falseColor.ts';
export { colorMatching, tristimulus, VISIBLE, WAVELENGTHS } from './observer/standardObserver.ts';
export { MATERIAL_PRESETS, type MaterialPreset } from './reflectance/materialPresets.ts';
export type { MeasuredReflectance } from './reflectance/measuredReflectance.ts';
export {
  type FilterResidual,
  filterFromRgb,
  reflectanceAt,
  type SpectralFilter,
  WHITE_FILTER,
} from './reflectance/spectralFilter.ts';
export { daylightSpectrum } from './sources/daylight.ts';
export { LIGHT_PRESETS, type LightPreset } from './sources/lightPresets.ts';
export {
  DAYLIGHT,
  type LightSpectrum,
  type LineSpectrum,
  linesOf,
  type SampledSpectrum,
  type SpectralLine,
  spectralRadiance,
  type ThermalSpectrum,
} from './sources/lightSpectrum.ts';
export { logLuminance, logPlanck } from './sources/planck.ts';
