import { exp2, log2, max } from 'three/tsl';
import type { Float, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import type { Emission } from '../gbuffer/surfacePacking.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';

/**
 * A spectral filter in one pixel: the coefficients r, g, b of spectrum/reflectance/spectralFilter.ts, and its transmission in the ultraviolet if D < 1 shifts
 * that into the visible, otherwise in the infrared; 0 if no surface of the scene specifies its own.
 */
export type SpectralFilterNodes = Vec4;

/** How light gets from its source to a surface. */
export interface IncidentSpectrum {
  /** ν at the surface/ν at the source; absent if it is 1. */
  readonly D?: Float;
  /** Absent for daylight. */
  readonly source?: SpectralSource;
  /**
   * For a blackbody behind a coloured filter the number of its table (spectrum/doppler/filterPairs.ts); `picture` for an image, whose colour differs with the
   * direction.
   */
  readonly colored?: number | 'picture';
}

/** The spectrum of light that is not daylight. */
export type SpectralSource = ThermalSource | LineSource | typeof SKY_SOURCE;

/** Daylight of which air has scattered the blue part (spectrum/color/scatteredLight.ts). */
export const SKY_SOURCE = { scatters: true } as const;

/** Light of single wavelengths [m, source's frame], each with its radiance; their total luminance is 1. */
export interface LineSource {
  each(visit: (wavelength: Float, radiance: Float) => void): void;
}

/** A blackbody [K], and its luminance over that of one of 6504 K. */
export interface ThermalSource {
  readonly temperature: Float;
  readonly luminance: Float;
}

/**
 * Powers of D. Radiance grows as D⁴. Per solid angle of the source's own frame it is L′ dΩ′ = D² L dΩ, so the irradiance of light from one direction is E′ =
 * D² E (docs/physics.md §6.1).
 */
export const RADIANCE_POWER = 4;
export const IRRADIANCE_POWER = 2;
export type BeamingPower = typeof RADIANCE_POWER | typeof IRRADIANCE_POWER;

/** Sums the light that reaches the observer in one pixel, from a surface or a sky that is seen with one D. */
export interface RadianceAccumulator {
  /** A colour as a filter; `invisible`: the surface's reflectance in the ultraviolet and infrared. */
  filter(rgb: Vec3, invisible?: Vec2): SpectralFilterNodes;
  /** Adds reflected light: `light` is the filter of its source, whose brightness is multiplied by D^power; `reflectance` is that of the surface. */
  addReflected(light: Vec3, reflectance: SpectralFilterNodes, incident: IncidentSpectrum, power: BeamingPower): void;
  /** Adds light that is emitted here. */
  addEmitted(light: Vec3, source?: SpectralSource): void;
  /** Adds a blackbody's light that is emitted here. */
  addGlow(emission: Pick<Emission, 'luminance' | 'log2Temperature'>): void;
  /** Adds the light of a blackbody of T [K] emitted here; `radiance`: that of one of 6504 K. However cold it is, D can shift it into the visible. */
  addBlackbody(T: number, radiance: Float): void;
  /** Linear sRGB of everything that was added. */
  total(): Vec3;
}

/** Makes the accumulator of a pixel that is seen with D. */
export type ColorPipeline = (D: Float, uniforms: FrameUniforms) => RadianceAccumulator;

/** D^(power · beaming), with the fraction of beaming in the settings. */
export const beamingFactor = (D: Float, power: number, { beaming }: FrameUniforms): Float =>
  exp2(log2(max(D, 1e-20)).mul(beaming.mul(power)));
