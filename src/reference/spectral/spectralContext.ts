import type { Vec3 } from '../../math/vec3.ts';
import type { SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { dopplerBetween, type RestFrame } from './restFrame.ts';
import type { SampledRadiance } from './sampledRadiance.ts';
import type { SourceSpectrum } from './sourceSpectrum.ts';

/** How light is asked for in one frame: at wavelengths of that frame (spectral.ts), or as linear sRGB (tinted.ts). */
export interface SpectralContext {
  emitted(shine: SourceSpectrum): SampledRadiance;
  /** What a surface or a pane leaves of light. */
  filtered(light: SampledRadiance, filter: SpectralFilter): SampledRadiance;
  /** The sight of a frame whose light arrives in this one with ν = D ν_there. */
  shifted(D: number): SpectralContext;
  /** Light of `through(D)` as it arrives here. Its brightness, over all wavelengths, is D^power times as great. */
  received(light: SampledRadiance, D: number, power: number): SampledRadiance;
}

/** Whoever sees the picture. */
export interface Sensor {
  readonly context: SpectralContext;
  /** Linear sRGB of what he sees. */
  color(light: SampledRadiance): Vec3;
}

/** Who receives light, and how. */
export interface LightReceiver {
  readonly frame: RestFrame;
  readonly context: SpectralContext;
}

/** Radiance L′ = D⁴ L; and, per solid angle of the emitter's own frame, L′ dΩ′ = D² L dΩ: so an irradiance E′ = D² E of light from one direction. */
export const RADIANCE_POWER = 4;
export const IRRADIANCE_POWER = 2;

/** The light that something at rest in `frame` sends out, as it arrives from n (unit, world). */
export function receivedLight(
  { frame, context: sight }: LightReceiver,
  n: Vec3,
  source: RestFrame,
  power: typeof RADIANCE_POWER | typeof IRRADIANCE_POWER,
  sent: (there: LightReceiver) => SampledRadiance,
): SampledRadiance {
  const D = dopplerBetween(n, frame, source);
  const there = { frame: source, context: sight.shifted(D) };
  return sight.received(sent(there), D, power);
}
