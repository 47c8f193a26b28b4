import { lerp, type Vec3 } from '../../../../math/vec3.ts';
import type { Material } from '../../../../scene/types.ts';

/** Normal reflectance of a dielectric with n = 1.5. */
const DIELECTRIC_F0 = 0.04;
/** Upper bound for dielectrics: diamond has 0.17. */
const MAX_DIELECTRIC_F0 = 0.25;

/**
 * Converts the specular workflow to metalness: reflectances above those of dielectrics are the more metallic the
 * darker the diffuse colour is; others determine the index of refraction by F₀ = ((n − 1)/(n + 1))².
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
