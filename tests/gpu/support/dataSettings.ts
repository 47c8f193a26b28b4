import { DEFAULT_SETTINGS, type RenderSettings } from '../../../src/scene/view/view.ts';

/** For tests that read only data: light, which takes most of a picture's time, is drawn without spectra, shadows, occlusion and antialiasing. */
export const DATA_SETTINGS: RenderSettings = {
  ...DEFAULT_SETTINGS,
  shadows: false,
  occlusionRadius: 0,
  antialiasing: false,
  colors: 'approximate',
  dopplerMix: 0,
  beaming: 0,
};
