import type { Vec3 } from '../math/vec3.ts';
import { type Bands, bandsOf } from '../spectrum/bands.ts';
import { DAYLIGHT, type LightSpectrum } from '../spectrum/lightSpectrum.ts';
import type { SurfacePoint } from './surface.ts';

/** What shines: a spectrum of luminance 1 behind a filter; and what a white surface shows of it at rest, linear sRGB. */
export interface Shine {
  readonly spectrum: LightSpectrum;
  readonly filter: Bands;
  readonly color: Vec3;
}

/** What shines with a spectrum, for any colour that a white surface is to show of it at rest. */
export function shining(spectrum: LightSpectrum = DAYLIGHT): (color: Vec3) => Shine {
  return (color) => ({ spectrum, filter: bandsOf(color), color });
}

/** What a surface shines with by itself. */
export const emissionOf = ({ emissive }: SurfacePoint): Shine => shining()(emissive);
