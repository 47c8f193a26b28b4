import { length, lerp, scale, type Vec3 } from '../../../math/vec3.ts';
import { FOG } from '../../../scene/frameGraph/effects.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

/**
 * Fog that rests in the world and fills it: I e^(−r/ℓ) + F (1 − e^(−r/ℓ)). r = |Δx| = c (t_o − t_e) is the retarded distance in the fog's rest frame, the world's:
 * what the light has travelled through it; the observer's own motion does not change it, and the apparent distance |Δx′| plays no part. F is not shifted by
 * the observer's motion. arg1: mean free path ℓ [m]; arg2: brightness of F; arg3: 0 grey, 1 blue as haze; arg4: how much of the sky it covers.
 */
export function fog(
  frame: GBufferReader,
  [path = 1, brightness = 0, haze = 0, overSky = 0]: readonly number[],
): FloatImage {
  const light = scale(lerp(FOG.gray, FOG.haze, haze), brightness);
  return frame.image.map((x, y) => {
    const covered = frame.isCovered(x, y) ? 1 - Math.exp(-length(frame.eventOffset(x, y)) / path) : overSky;
    return lerp(frame.image.at(x, y) as unknown as Vec3, light, covered);
  });
}
