import { filterOfReflectance } from '../../spectrum/color/filterOfReflectance.ts';
import type { MeasuredReflectance } from '../../spectrum/reflectance/measuredReflectance.ts';
import type { Material } from '../types.ts';

/** What a measured reflectance says of a material: itself, and its bands. */
export function measuredMaterial(
  reflectance: MeasuredReflectance,
): Pick<Material, 'reflectance' | 'baseColor'> & Partial<Pick<Material, 'uv' | 'ir'>> {
  const { rgb, uv, ir } = filterOfReflectance(reflectance);
  return { reflectance, baseColor: rgb, uv, ir };
}
