import type { Vec3 } from '../math/vec3.ts';
import type { Bands } from '../spectrum/bands.ts';
import type { Light } from './light.ts';
import { dopplerBetween, type RestFrame } from './restFrame.ts';
import type { Shine } from './shine.ts';

/** How light is asked for in one frame: at wavelengths of that frame (spectral.ts), or as linear sRGB (tinted.ts). */
export interface Sight {
  shining(shine: Shine): Light;
  /** What a surface or a pane leaves of light. */
  filtered(light: Light, filter: Bands): Light;
  /** The sight of a frame whose light arrives in this one with ν = D ν_there. */
  through(D: number): Sight;
  /** Light of `through(D)` as it arrives here. Its brightness, over all wavelengths, is D^power times as great. */
  arrived(light: Light, D: number, power: number): Light;
}

/** Whoever sees the picture. */
export interface Eye {
  readonly sight: Sight;
  /** Linear sRGB of what he sees. */
  color(light: Light): Vec3;
}

/** Who receives light, and how. */
export interface Receiver {
  readonly frame: RestFrame;
  readonly sight: Sight;
}

/** Radiance L′ = D⁴ L; and, per solid angle of the emitter's own frame, L′ dΩ′ = D² L dΩ: so an irradiance E′ = D² E of light from one direction. */
export const RADIANCE = 4;
export const IRRADIANCE = 2;

/** The light that something at rest in `frame` sends out, as it arrives from n (unit, world). */
export function received(
  { frame, sight }: Receiver,
  n: Vec3,
  source: RestFrame,
  power: typeof RADIANCE | typeof IRRADIANCE,
  sent: (there: Receiver) => Light,
): Light {
  const D = dopplerBetween(n, frame, source);
  const there = { frame: source, sight: sight.through(D) };
  return sight.arrived(sent(there), D, power);
}
