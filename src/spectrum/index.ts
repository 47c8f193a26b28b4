export { type Bands, bandsOf, basisAt, ENDS, reflectanceAt, WHITE } from './bands.ts';
export { colorMatching, NANOMETRE, tristimulus, VISIBLE, WAVELENGTHS } from './cie1931.ts';
export { columnOf, type DopplerTable, SHIFT_LIMIT, tableColor, tableTexel } from './dopplerTable.ts';
export { dopplerTint } from './dopplerTint.ts';
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
export { NORMALISER, seenColor, toLinearSrgb, whiteOf } from './observerColor.ts';
export { logLuminance, logPlanck, SECOND_RADIATION } from './planck.ts';
export { type SampledTable, sampledTable, shiftRowOf } from './sampledTable.ts';
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
