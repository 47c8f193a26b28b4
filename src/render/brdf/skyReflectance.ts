import { clamp, exp2, pow } from 'three/tsl';
import type { Float } from '../../shaders/types.ts';
import type { SpectralFilterNodes } from '../color/radiance.ts';
import { type BrdfNodes, environmentBrdf } from './brdf.ts';

/** What a surface makes of the sky's light. */
export interface SkyReflectance {
  readonly diffuse: SpectralFilterNodes;
  readonly specular: SpectralFilterNodes;
}

/** `openness`: share of the sky, weighted by the cosine, that nothing hides; absent: all of it. */
export function skyReflectance(look: BrdfNodes, openness?: Float): SkyReflectance {
  const { diffuse } = look;
  const mirrored = environmentBrdf(look);
  return openness
    ? { diffuse: diffuse.mul(openness), specular: mirrored.mul(specularOpenness(look, openness)) }
    : { diffuse, specular: mirrored };
}

/**
 * How much of what a surface mirrors is open sky: nearly all on a smooth one that is seen at a flat angle, as much as of all the sky on a rough one.
 * Source: Lagarde, de Rousiers 2014, "Moving Frostbite to physically based rendering", course notes, listing 26; α = roughness².
 */
const specularOpenness = ({ roughness, NV }: BrdfNodes, openness: Float): Float =>
  clamp(
    pow(NV.add(openness), exp2(roughness.mul(roughness).mul(-16).sub(1)))
      .sub(1)
      .add(openness),
    0,
    1,
  );
