export { blackbodyColor, glowColor } from './color/blackbodyColor.ts';
export { lightFilter } from './color/lightFilter.ts';
export {
  colorOfSpectrum,
  LUMINANCE_WEIGHTS,
  observedColor,
  toLinearSrgb,
  XYZ_TO_RENDER_SRGB,
} from './color/observerColor.ts';
export { P3_TO_XYZ, SRGB_TO_P3, SRGB_TO_XYZ, XYZ_TO_P3, XYZ_TO_SRGB } from './display/rgbSpaces.ts';
export { toneMap } from './display/toneMap.ts';
export { columnOf, type DopplerTable, SHIFT_LIMIT, tableColor, tableTexel } from './doppler/dopplerTable.ts';
export { dopplerTint } from './doppler/dopplerTint.ts';
export {
  type BlackbodyCurve,
  blackbodyCurve,
  blackbodyLuminance,
  LUMINANCE_THETA,
  MIDDLE_TEMPERATURE,
  rowOf,
  thermalTable,
} from './doppler/thermalTable.ts';
export { colorMatching, NANOMETRE, tristimulus, VISIBLE, WAVELENGTHS } from './observer/standardObserver.ts';
export { MATERIAL_PRESETS, type MaterialPreset } from './reflectance/materialPresets.ts';
export {
  BASIS_ENDS,
  basisAt,
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
export { logLuminance, logPlanck, SECOND_RADIATION } from './sources/planck.ts';
