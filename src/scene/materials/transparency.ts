import type { Material, Texture } from '../types.ts';

/** Whether a material is blended: not opaque, and without an opacity threshold. */
export function isTransparent({ opacity, opacityThreshold, baseColorTexture }: Material): boolean {
  if (opacityThreshold > 0) return false;
  return opacity < 1 || (baseColorTexture !== undefined && hasAlpha(baseColorTexture));
}

/** Whether any texel is not opaque. */
function hasAlpha({ data }: Texture): boolean {
  for (let i = 3; i < data.length; i += 4) if (data[i] < 255) return true;
  return false;
}
