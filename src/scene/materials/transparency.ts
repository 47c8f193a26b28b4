import type { Material, Texture } from '../types.ts';

/** Blended, where it is neither opaque nor cut out. */
export function isTransparent({ opacity, opacityThreshold, baseColorTexture }: Material): boolean {
  if (opacityThreshold > 0) return false;
  return opacity < 1 || (baseColorTexture !== undefined && hasAlpha(baseColorTexture));
}

/** Whether any texel is not opaque. */
function hasAlpha({ data }: Texture): boolean {
  for (let i = 3; i < data.length; i += 4) if (data[i] < 255) return true;
  return false;
}
