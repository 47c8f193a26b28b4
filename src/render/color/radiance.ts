import { exp2, log2, max } from 'three/tsl';
import type { Float, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import type { Emission } from '../gbuffer/surfacePacking.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';

/**
 * A filter of light in one pixel: the coefficients r, g, b of spectrum/reflectance/spectralFilter.ts, and its ultraviolet where D < 1 brings that into sight, else its
 * infrared; 0 where no surface of the scene tells of its own.
 */
export type SpectralFilterNodes = Vec4;

/** How light comes from its source to a surface. */
export interface IncidentSpectrum {
  /** ν at the surface/ν at the source; absent where it is 1. */
  readonly D?: Float;
  /** Absent of daylight. */
  readonly source?: SpectralSource;
  /** Where a blackbody shines through a filter with a colour: the number of its table (spectrum/doppler/filterPairs.ts), or a picture, of which each direction has its own. */
  readonly colored?: number | 'picture';
}

/** What light is made of, where that is not daylight. */
export type SpectralSource = ThermalSource | LineSource | typeof SKY_SOURCE;

/** Daylight of which air scatters the blue part (spectrum/color/scatteredLight.ts). */
export const SKY_SOURCE = { scatters: true } as const;

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
export const RADIANCE_POWER = 4;
export const IRRADIANCE_POWER = 2;
export type BeamingPower = typeof RADIANCE_POWER | typeof IRRADIANCE_POWER;

/** Adds up what comes to the observer of one pixel, from a surface or a sky that is seen with one D. */
export interface RadianceAccumulator {
  /** A colour as a filter; `invisible`: what a surface tells of its ultraviolet and infrared. */
  filter(rgb: Vec3, invisible?: Vec2): SpectralFilterNodes;
  /** Light that a surface sends on: `light` is the filter of its source, which came brighter by D^power, `share` what the surface makes of it. */
  addReflected(light: Vec3, share: SpectralFilterNodes, passage: IncidentSpectrum, power: BeamingPower): void;
  /** Light that is sent out here. */
  addEmitted(light: Vec3, source?: SpectralSource): void;
  /** Light of a blackbody that is sent out here. */
  addGlow(emission: Pick<Emission, 'luminance' | 'log2Temperature'>): void;
  /** Light of a blackbody of T [K], sent out here; `radiance`: of one of 6504 K. However cold it is, D can bring it into sight. */
  addBlackbody(T: number, radiance: Float): void;
  /** Linear sRGB of all that was sent. */
  total(): Vec3;
}

/** A Gathering for pixels that are seen with D. */
export type ColorPipeline = (D: Float, uniforms: FrameUniforms) => RadianceAccumulator;

/** Shifts below this change no pixel, and most surfaces rest: colours are left as they are there. */
export const MIN_SHIFT = 1e-5;

/** D^(power · beaming): the share of the beaming that the settings ask for. */
export const beamingFactor = (D: Float, power: number, { beaming }: FrameUniforms): Float =>
  exp2(log2(max(D, 1e-20)).mul(beaming.mul(power)));
