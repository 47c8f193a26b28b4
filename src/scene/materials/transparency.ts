import type { Material, Texture } from '../types.ts';

/** Whether light passes a material: it is not opaque, and has no opacity threshold, or it is transmissive. */
export function isTransparent({ opacity, opacityThreshold, baseColorTexture, transmission }: Material): boolean {
  if (transmission) return true;
  if (opacityThreshold > 0) return false;
  return opacity < 1 || (baseColorTexture !== undefined && hasAlpha(baseColorTexture));
}

/** Whether any texel is not opaque. */
function hasAlpha({ data }: Texture): boolean {
  for (let i = 3; i < data.length; i += 4) if (data[i] < 255) return true;
  return false;
}
