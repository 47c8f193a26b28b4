import { dot, floor, fract, screenCoordinate, vec2 } from 'three/tsl';
import type { Float } from '../../shaders/types.ts';

/**
 * A number from 0 to 1 for each pixel, unlike those of its neighbours (interleaved gradient noise: Jimenez 2014, "Next generation post processing in Call of
 * Duty").
 */
export const interleavedGradientNoise = (): Float =>
  fract(fract(dot(floor(screenCoordinate), vec2(0.06711056, 0.00583715))).mul(52.9829189));
