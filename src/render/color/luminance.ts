import { dot, vec3 } from 'three/tsl';
import { relativeLuminance as luminanceOfRgb } from '../../scene/view/metering.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';

/** `relativeLuminance` of linear sRGB, on the GPU. */
export const relativeLuminance = (rgb: Vec3): Float =>
  dot(rgb, vec3(luminanceOfRgb(1, 0, 0), luminanceOfRgb(0, 1, 0), luminanceOfRgb(0, 0, 1)));
