import type { Vec3 } from '../../math/vec3.ts';
import type { SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { dopplerBetween, type RestFrame } from './restFrame.ts';
import type { SampledRadiance } from './sampledRadiance.ts';
import type { SourceSpectrum } from './sourceSpectrum.ts';

/** Samples light in one frame: at wavelengths of that frame (spectralSensor.ts), or as linear sRGB (rgbSensor.ts). */
export interface SpectralContext {
  emitted(source: SourceSpectrum): SampledRadiance;
  /** A sum of several lights as one light. */
  together(light: SampledRadiance): SampledRadiance;
  /** Light after reflection or transmission by a filter. */
  filtered(light: SampledRadiance, filter: SpectralFilter): SampledRadiance;
  /** Light after absorption: by the filter's value to the power x at every wavelength. */
  absorbed(light: SampledRadiance, filter: SpectralFilter, x: number): SampledRadiance;
  /** Its wavelengths [m, this frame], of RGB those of the three channels; empty where lights are no spectra. */
  readonly samples: readonly number[];
  /** The context of a frame whose light arrives in this one with ν = D ν_there. */
  shifted(D: number): SpectralContext;
  /** Light sampled in `shifted(D)` as it arrives here: integrated over all wavelengths it is multiplied by D^power. */
  received(light: SampledRadiance, D: number, power: number): SampledRadiance;
}

/** The sensor of the picture's observer. */
export interface Sensor {
  readonly context: SpectralContext;
  /** Linear sRGB of received light. */
  color(light: SampledRadiance): Vec3;
}

/** The rest frame of a receiver of light, and its spectral sampling. */
export interface LightReceiver {
  readonly frame: RestFrame;
  readonly context: SpectralContext;
}

/** Radiance L′ = D⁴ L; per solid angle of the emitter's own frame L′ dΩ′ = D² L dΩ, so an irradiance E′ = D² E of light from one direction. docs/physics.md §6.1. */
export const RADIANCE_POWER = 4;
export const IRRADIANCE_POWER = 2;

/** Light emitted at rest in `source`, as it arrives at the receiver from n (unit, world). */
export function receivedLight(
  { frame, context }: LightReceiver,
  n: Vec3,
  source: RestFrame,
  power: typeof RADIANCE_POWER | typeof IRRADIANCE_POWER,
  sent: (there: LightReceiver) => SampledRadiance,
): SampledRadiance {
  const D = dopplerBetween(n, frame, source);
  const there = { frame: source, context: context.shifted(D) };
  return context.received(sent(there), D, power);
}
