import { dot, scale, type Vec3 } from '../../math/vec3.ts';
import { glowColor } from '../../spectrum/color/blackbodyColor.ts';
import { lightFilter } from '../../spectrum/color/lightFilter.ts';
import { LUMINANCE_WEIGHTS } from '../../spectrum/color/observerColor.ts';
import { neutralFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import { filterFromRgb, type SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT, type LightSpectrum, type ThermalSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import type { SurfacePoint } from '../materials/surface.ts';

/** The light of a source: a spectrum of luminance 1 behind a filter, and its linear sRGB for approximate colours. */
export interface SourceSpectrum {
  readonly spectrum: LightSpectrum;
  readonly filter: SpectralFilter;
  readonly color: Vec3;
}

/** The source spectrum of a light, from its colour and spectrum. */
export const sourceSpectrumOf = (color: Vec3, spectrum: LightSpectrum = DAYLIGHT): SourceSpectrum => ({
  spectrum,
  filter: spectrum === DAYLIGHT ? filterFromRgb(color) : lightFilter(color, spectrum),
  color,
});

/** The emission of a surface: its emissive colour as daylight, or a blackbody of that luminance. */
export function emittedSpectrum({ emissive: color, temperature }: SurfacePoint): SourceSpectrum {
  if (temperature === undefined) return sourceSpectrumOf(color);
  const luminance = dot(LUMINANCE_WEIGHTS, color);
  return {
    spectrum: blackbody(temperature),
    filter: neutralFilter(luminance),
    color: scale(glowColor(temperature), luminance),
  };
}

/** One object per temperature [K], because tables of spectra are cached by object. */
const blackbodies = new Map<number, ThermalSpectrum>();

function blackbody(temperature: number): ThermalSpectrum {
  const cached = blackbodies.get(temperature);
  if (cached) return cached;
  const spectrum = { kind: 'thermal', temperature } as const;
  blackbodies.set(temperature, spectrum);
  return spectrum;
}
