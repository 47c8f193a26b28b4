import { filterOfReflectance } from '../../spectrum/color/filterOfReflectance.ts';
import type { MeasuredReflectance } from '../../spectrum/reflectance/measuredReflectance.ts';
import type { Material } from '../types.ts';

/** The material properties that follow from a measured reflectance: itself and its bands. */
export function measuredMaterial(
  reflectance: MeasuredReflectance,
): Pick<Material, 'reflectance' | 'baseColor'> & Partial<Pick<Material, 'uv' | 'ir'>> {
  const { rgb, uv, ir } = filterOfReflectance(reflectance);
  return { reflectance, baseColor: rgb, uv, ir };
}
