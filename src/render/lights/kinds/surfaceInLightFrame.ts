import { dot, vec4 } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { SpectralFilterNodes } from '../../color/radiance.ts';
import type { RestFrameNodes } from '../restFrame.ts';

/**
 * A surface in the rest frame of a light: four-velocity U and normal N as four-vectors (x, ct). Light from a direction n of that frame
 * (unit, surface → light) arrives with D = U·n + U₀ at the angle θ from the normal, D cos θ = N·n + N₀.
 */
export interface SurfaceInLightFrame {
  readonly N: Vec4;
  /** Absent if both rest in the world. */
  readonly U?: Vec4;
}

/** `N`: unit normal in the surface's rest frame `here`; `there`: the light's rest frame. */
export function surfaceInLightFrame(N: Vec3, here: RestFrameNodes, there: RestFrameNodes): SurfaceInLightFrame {
  if (!here.doppler && !there.doppler) return { N: vec4(N, 0).toVar() };
  const transform = (X: Vec4): Vec4 => there.boostInto(here.boostOut(X)).toVar();
  return { N: transform(vec4(N, 0)), U: transform(vec4(0, 0, 0, 1)) };
}

/** D of light from the direction `n` of the light's frame. */
export const dopplerFrom = ({ U }: SurfaceInLightFrame, n: Vec3): Float | undefined =>
  U && dot(U.xyz, n).add(U.w).max(1e-6).toVar();

/** Mean D of a light's light, and its irradiance over D² for a radiance of 1. */
export interface MeanLight {
  readonly D?: Float;
  readonly irradiance: Float;
}

/**
 * From the integrals over the light's solid angle of D cos θ, `amount`, and of n D cos θ, `toward`: E = ∫ D² cos θ dΩ, and the
 * mean D is E/amount.
 */
export function meanLight({ U }: SurfaceInLightFrame, amount: Float, toward: Vec3): MeanLight {
  if (!U) return { irradiance: amount };
  const D = dot(U.xyz, toward).div(amount.max(1e-12)).add(U.w).max(1e-6).toVar();
  return { D, irradiance: amount.div(D) };
}

/** The radiance that a surface reflects per unit of a light's radiance or intensity, and the D of the incident light. */
export interface ReflectedLight {
  readonly reflectance: SpectralFilterNodes;
  readonly D?: Float;
}

/** Without `specular`, `diffuse` includes it. */
export type AddReflected = (diffuse: ReflectedLight, specular?: ReflectedLight) => void;
