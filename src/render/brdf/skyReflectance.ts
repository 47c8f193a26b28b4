import { clamp, dot, exp2, length, max, mix, normalize, pow, reflect, smoothstep, sqrt } from 'three/tsl';
import type { Float, Vec3 } from '../../shaders/types.ts';
import type { SpectralFilterNodes } from '../color/radiance.ts';
import { type BrdfNodes, environmentBrdf } from './brdf.ts';

/** The factors of the sky's light that a surface reflects. */
export interface SkyReflectance {
  readonly diffuse: SpectralFilterNodes;
  readonly specular: SpectralFilterNodes;
}

/** `openness`: unoccluded fraction of the sky, weighted by the cosine; all of it if absent. */
export function skyReflectance(brdf: BrdfNodes, openness?: Float): SkyReflectance {
  const { diffuse } = brdf;
  const mirrored = environmentBrdf(brdf);
  return openness
    ? { diffuse: diffuse.mul(openness), specular: mirrored.mul(specularOpenness(brdf, openness)) }
    : { diffuse, specular: mirrored };
}

/**
 * Unoccluded fraction of the specular lobe: nearly all of it on a smooth surface at grazing angles, `openness` on a rough one. Source: Lagarde, de Rousiers
 * 2014, "Moving Frostbite to physically based rendering", course notes, listing 26; α = roughness².
 */
const specularOpenness = ({ roughness, NV }: BrdfNodes, openness: Float): Float =>
  clamp(
    pow(NV.add(openness), exp2(roughness.mul(roughness).mul(-16).sub(1)))
      .sub(1)
      .add(openness),
    0,
    1,
  );

/** Roughness between which the axis of the specular lobe goes over from the mirrored ray to the mean direction of what is reflected. */
const MIRRORED_TO_MEAN = [0.1, 0.3] as const;

/** The direction about which the sky is reflected, whose cosine to the normal is that of the lobe on a rough surface; that of the mirrored ray on a smooth one. */
export function lobeAxis({ N, V, roughness }: BrdfNodes, cosine: Float): Vec3 {
  const mirrored = reflect(V.negate(), N).toVar();
  const across = mirrored.sub(N.mul(dot(N, mirrored))).toVar();
  const level = sqrt(max(cosine.mul(cosine).oneMinus(), 0)).div(max(length(across), 1e-4));
  const middle = N.mul(cosine).add(across.mul(level));
  return normalize(mix(mirrored, middle, smoothstep(...MIRRORED_TO_MEAN, roughness)));
}
