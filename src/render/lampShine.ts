import type { Vec3 } from '../math/vec3.ts';
import type { DistantLight, Lamp } from '../scene/types.ts';
import type { ColorMode } from '../scene/view.ts';
import { lightFilter } from '../spectrum/lightFilter.ts';
import { DAYLIGHT, type LightSpectrum } from '../spectrum/lightSpectrum.ts';
import { logLuminance } from '../spectrum/planck.ts';

/** What tells shaders apart by which light is turned: all blackbodies of 6504 K together, others one by one. */
export type ShineKind = 'daylight' | 'thermal';

export const shineKind = ({ spectrum = DAYLIGHT }: { readonly spectrum?: LightSpectrum }): ShineKind =>
  spectrum.kind === 'thermal' && spectrum.temperature !== DAYLIGHT.temperature ? 'thermal' : 'daylight';

/** A light's filter before its spectrum; of approximate colours what is seen of it at rest. */
export function shineColor({ color, spectrum = DAYLIGHT }: DistantLight | Lamp, colors: ColorMode): Vec3 {
  if (colors === 'approximate' || spectrum === DAYLIGHT) return color;
  return lightFilter(color, spectrum).rgb;
}

/** Temperature [K], and the luminance of such a blackbody over that of daylight's. */
export function thermalTexel({ spectrum = DAYLIGHT }: DistantLight | Lamp): readonly [number, number] {
  const T = spectrum.kind === 'thermal' ? spectrum.temperature : DAYLIGHT.temperature;
  return [T, Math.exp(logLuminance(T) - logLuminance(DAYLIGHT.temperature))];
}
