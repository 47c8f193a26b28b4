import { dot, scale, type Vec3 } from '../../math/vec3.ts';
import { glowColor } from '../../spectrum/color/blackbodyColor.ts';
import { lightFilter } from '../../spectrum/color/lightFilter.ts';
import { LUMINANCE_WEIGHTS } from '../../spectrum/color/observerColor.ts';
import { neutralFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import { filterFromRgb, type SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT, type LightSpectrum, type ThermalSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import type { SurfacePoint } from '../materials/surface.ts';

/** What shines: a spectrum of luminance 1 behind a filter; and the linear sRGB that the approximate colours take it for. */
export interface SourceSpectrum {
  readonly spectrum: LightSpectrum;
  readonly filter: SpectralFilter;
  readonly color: Vec3;
}

/** A light's, by its spectrum and colour. */
export const sourceSpectrumOf = (color: Vec3, spectrum: LightSpectrum = DAYLIGHT): SourceSpectrum => ({
  spectrum,
  filter: spectrum === DAYLIGHT ? filterFromRgb(color) : lightFilter(color, spectrum),
  color,
});

/** What a surface shines with by itself: its colour in daylight, or a blackbody of its luminance. */
export function emittedSpectrum({ emissive: color, temperature }: SurfacePoint): SourceSpectrum {
  if (temperature === undefined) return sourceSpectrumOf(color);
  const luminance = dot(LUMINANCE_WEIGHTS, color);
  return {
    spectrum: blackbody(temperature),
    filter: neutralFilter(luminance),
    color: scale(glowColor(temperature), luminance),
  };
}

/** One for each temperature [K] of a material, for what is found out about spectra is kept with them. */
const blackbodies = new Map<number, ThermalSpectrum>();

function blackbody(temperature: number): ThermalSpectrum {
  const known = blackbodies.get(temperature);
  if (known) return known;
  const made = { kind: 'thermal', temperature } as const;
  blackbodies.set(temperature, made);
  return made;
}
