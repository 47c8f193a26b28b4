import { lerp, type Vec3 } from '../../../../math/vec3.ts';
import type { Material } from '../../../../scene/types.ts';

/** Normal reflectance of a dielectric with n = 1.5. */
const DIELECTRIC_F0 = 0.04;
/** Upper bound for dielectrics: diamond has 0.17. */
const MAX_DIELECTRIC_F0 = 0.25;

/**
 * The metal–glass material that is nearest to a diffuse and a mirrored colour: what mirrors more than any dielectric is the more of a metal the
 * darker its diffuse colour is, the rest refracts as its mirrored share says, F₀ = ((n − 1)/(n + 1))².
 */
export function metallicFromSpecular(
  diffuse: Vec3,
  specular: Vec3,
  textured: boolean,
): Pick<Material, 'baseColor' | 'metallic' | 'ior'> {
  const most = Math.max(...specular);
  if (most <= MAX_DIELECTRIC_F0 || textured) {
    const root = Math.sqrt(Math.min(Math.max((specular[0] + specular[1] + specular[2]) / 3, 0), MAX_DIELECTRIC_F0));
    return { baseColor: diffuse, metallic: 0, ior: (1 + root) / (1 - root) };
  }
  const metallic = (most - DIELECTRIC_F0) / (most - DIELECTRIC_F0 + Math.max(...diffuse, 0));
  return { baseColor: lerp(diffuse, specular, metallic), metallic };
}
