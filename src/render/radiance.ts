import { exp2, log2, max } from 'three/tsl';
import type { Float, Vec2, Vec3, Vec4 } from '../shaders/types.ts';
import type { Emission } from './surfaceCode.ts';
import type { Uniforms } from './uniforms.ts';

/**
 * A filter of light in one pixel: the coefficients r, g, b of spectrum/bands.ts, and its ultraviolet where D < 1 brings that into sight, else its
 * infrared; 0 where no surface of the scene tells of its own.
 */
export type Filter = Vec4;

/** How light comes from its source to a surface. */
export interface Passage {
  /** ν at the surface/ν at the source; absent where it is 1. */
  readonly D?: Float;
  /** Absent of daylight. */
  readonly source?: Source;
  /** Where a blackbody shines through a filter with a colour: the number of its table (spectrum/filterPairs.ts), or a picture, of which each direction has its own. */
  readonly colored?: number | 'picture';
}

/** What light is made of, where that is not daylight. */
export type Source = ThermalSource | LineSource | typeof SKY;

/** Daylight of which air scatters the blue part (spectrum/scatteredLight.ts). */
export const SKY = { scatters: true } as const;

/** Light of single wavelengths [m, source's frame], each with its radiance; of luminance 1 in all. */
export interface LineSource {
  each(visit: (wavelength: Float, radiance: Float) => void): void;
}

/** A blackbody [K], and its luminance over that of one of 6504 K. */
export interface ThermalSource {
  readonly temperature: Float;
  readonly luminance: Float;
}

/** Radiance grows as D⁴. Per solid angle of the source's own frame it is L′ dΩ′ = D² L dΩ: so an irradiance E′ = D² E of light from one direction. */
export const RADIANCE = 4;
export const IRRADIANCE = 2;
export type Power = typeof RADIANCE | typeof IRRADIANCE;

/** Adds up what comes to the observer of one pixel, from a surface or a sky that is seen with one D. */
export interface Gathering {
  /** A colour as a filter; `invisible`: what a surface tells of its ultraviolet and infrared. */
  filter(rgb: Vec3, invisible?: Vec2): Filter;
  /** Light that a surface sends on: `light` is the filter of its source, which came brighter by D^power, `share` what the surface makes of it. */
  send(light: Vec3, share: Filter, passage: Passage, power: Power): void;
  /** Light that is sent out here. */
  emit(light: Vec3, source?: Source): void;
  /** Light of a blackbody that is sent out here. */
  glow(emission: Pick<Emission, 'luminance' | 'heat'>): void;
  /** Light of a blackbody of T [K], sent out here; `radiance`: of one of 6504 K. However cold it is, D can bring it into sight. */
  radiate(T: number, radiance: Float): void;
  /** Linear sRGB of all that was sent. */
  seen(): Vec3;
}

/** A Gathering for pixels that are seen with D. */
export type Optics = (D: Float, uniforms: Uniforms) => Gathering;

/** Shifts below this change no pixel, and most surfaces rest: colours are left as they are there. */
export const NO_SHIFT = 1e-5;

/** D^(power · beaming): the share of the beaming that the settings ask for. */
export const beamed = (D: Float, power: number, { beaming }: Uniforms): Float =>
  exp2(log2(max(D, 1e-20)).mul(beaming.mul(power)));
