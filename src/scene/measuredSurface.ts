import type { Reflectance } from '../spectrum/measured.ts';
import { bandsOfReflectance } from '../spectrum/reflectance.ts';
import type { Material } from './types.ts';

/** What a measured reflectance says of a material: itself, and its bands. */
export function measuredSurface(
  reflectance: Reflectance,
): Pick<Material, 'reflectance' | 'baseColor'> & Partial<Pick<Material, 'uv' | 'ir'>> {
  const { rgb, uv, ir } = bandsOfReflectance(reflectance);
  return { reflectance, baseColor: rgb, uv, ir };
}
