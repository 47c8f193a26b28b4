export { type Bands, bandsOf, basisAt, ENDS, reflectanceAt, WHITE } from './bands.ts';
export { colorMatching, NANOMETRE, tristimulus, VISIBLE, WAVELENGTHS } from './cie1931.ts';
export { daylightSpectrum } from './daylight.ts';
export { columnOf, type DopplerTable, SHIFT_LIMIT, tableColor, tableTexel } from './dopplerTable.ts';
export { dopplerTint } from './dopplerTint.ts';
export { lightFilter } from './lightFilter.ts';
export { LIGHT_PRESETS, type LightPreset } from './lightPresets.ts';
export {
  DAYLIGHT,
  type LightSpectrum,
  type LineSpectrum,
  linesOf,
  type SampledSpectrum,
  type SpectralLine,
  spectralRadiance,
  type ThermalSpectrum,
} from './lightSpectrum.ts';
export { MATERIAL_PRESETS, type MaterialPreset } from './materialPresets.ts';
export { LUMINANCE, NORMALISER, seenColor, toLinearSrgb, whiteOf } from './observerColor.ts';
export { logLuminance, logPlanck, SECOND_RADIATION } from './planck.ts';
export { blackbodyColor, glowColor } from './planckian.ts';
export { P3_TO_XYZ, SRGB_TO_P3, SRGB_TO_XYZ, XYZ_TO_P3, XYZ_TO_SRGB } from './rgbSpaces.ts';
export {
  type BlackbodyCurve,
  blackbodyCurve,
  LUMINANCE_THETA,
  luminanceOf,
  MIDDLE_TEMPERATURE,
  rowOf,
  thermalTable,
} from './thermalTable.ts';
export { toneMap } from './toneMap.ts';
