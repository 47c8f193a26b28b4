import { clamp, exp2, pow } from 'three/tsl';
import type { Float } from '../../shaders/types.ts';
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
