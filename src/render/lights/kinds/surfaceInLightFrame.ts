import { dot, vec4 } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { SpectralFilterNodes } from '../../color/radiance.ts';
import type { RestFrameNodes } from '../restFrame.ts';

/**
 * A surface as it is in the rest frame of a light, by four-vectors (x, ct): its own velocity U and its normal N. Light from a direction n of that frame
 * (unit, surface → light) comes with D = U·n + U₀ and meets the surface at the angle θ from its normal with D cos θ = N·n + N₀.
 */
export interface SurfaceInLightFrame {
  readonly N: Vec4;
  /** Absent where both rest in the world. */
  readonly U?: Vec4;
}

/** `N`: unit, of a surface at rest `here`; `there` the light rests. */
export function surfaceInLightFrame(N: Vec3, here: RestFrameNodes, there: RestFrameNodes): SurfaceInLightFrame {
  if (!here.doppler && !there.doppler) return { N: vec4(N, 0).toVar() };
  const across = (X: Vec4): Vec4 => there.boostInto(here.boostOut(X)).toVar();
  return { N: across(vec4(N, 0)), U: across(vec4(0, 0, 0, 1)) };
}

/** D of light from the direction `n` of the light's frame. */
export const dopplerFrom = ({ U }: SurfaceInLightFrame, n: Vec3): Float | undefined =>
  U && dot(U.xyz, n).add(U.w).max(1e-6).toVar();

/** What all of a light's light does together: its mean D, and for a radiance of 1 its irradiance over D². */
export interface MeanLight {
  readonly D?: Float;
  readonly irradiance: Float;
}

/**
 * Of the sum over the light's solid angle of D cos θ, `amount`, and of n D cos θ, `toward`: E = ∫ D² cos θ dΩ, in which D² is beaming,
 * has the mean D E/amount.
 */
export function meanLight({ U }: SurfaceInLightFrame, amount: Float, toward: Vec3): MeanLight {
  if (!U) return { irradiance: amount };
  const D = dot(U.xyz, toward).div(amount.max(1e-12)).add(U.w).max(1e-6).toVar();
  return { D, irradiance: amount.div(D) };
}

/** What a surface sends on of a light's light that came with D, as of an irradiance. */
export interface ReflectedLight {
  readonly share: SpectralFilterNodes;
  readonly D?: Float;
}

/** `glossy` absent: one share has both. */
export type AddReflected = (matt: ReflectedLight, glossy?: ReflectedLight) => void;
