import { dot, scale, type Vec3 } from '../math/vec3.ts';
import { type Bands, bandsOf } from '../spectrum/bands.ts';
import { lightFilter } from '../spectrum/lightFilter.ts';
import { DAYLIGHT, type LightSpectrum, type ThermalSpectrum } from '../spectrum/lightSpectrum.ts';
import { LUMINANCE } from '../spectrum/observerColor.ts';
import { glowColor } from '../spectrum/planckian.ts';
import { neutral } from './filters.ts';
import type { SurfacePoint } from './surface.ts';

/** What shines: a spectrum of luminance 1 behind a filter; and the linear sRGB that the approximate colours take it for. */
export interface Shine {
  readonly spectrum: LightSpectrum;
  readonly filter: Bands;
  readonly color: Vec3;
}

/** A light's, by its spectrum and colour. */
export const shineOf = (color: Vec3, spectrum: LightSpectrum = DAYLIGHT): Shine => ({
  spectrum,
  filter: spectrum === DAYLIGHT ? bandsOf(color) : lightFilter(color, spectrum),
  color,
});

/** What a surface shines with by itself: its colour in daylight, or a blackbody of its luminance. */
export function emissionOf({ emissive: color, temperature }: SurfacePoint): Shine {
  if (temperature === undefined) return shineOf(color);
  const luminance = dot(LUMINANCE, color);
  return {
    spectrum: blackbody(temperature),
    filter: neutral(luminance),
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
