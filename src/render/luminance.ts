import { dot, vec3 } from 'three/tsl';
import { luminanceOf } from '../scene/gauge.ts';
import type { Float, Vec3 } from '../shaders/types.ts';

/** Of linear sRGB: `luminanceOf` on the GPU. */
export const luminance = (rgb: Vec3): Float =>
  dot(rgb, vec3(luminanceOf(1, 0, 0), luminanceOf(0, 1, 0), luminanceOf(0, 0, 1)));
