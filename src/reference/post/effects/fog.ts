import { length, lerp, scale, type Vec3 } from '../../../math/vec3.ts';
import { FOG } from '../../../scene/frameGraph/effects.ts';
import { SKY_SHAPE } from '../../../scene/lights/skyGradient.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';
import { backdrop } from './skyBackground.ts';

/**
 * Homogeneous fog at rest in the world: I e^(−r/ℓ) + F (1 − e^(−r/ℓ)). r = |Δx| = c (t_o − t_e) is the distance that the light has travelled in the
 * fog's rest frame, the world; unlike the apparent distance |Δx′| it does not depend on the observer's motion. F is not Doppler shifted.
 * arg1: mean free path ℓ [m]; arg2: brightness of F; arg3: 0 grey, 1 blue haze; arg4: opacity in front of the sky. With a colour of fog, F is that, or the
 * sky in the same direction (`backdrop`), times the brightness.
 */
export function fog(
  frame: GBufferReader,
  [path = 1, brightness = 0, haze = 0, overSky = 0]: readonly number[],
): FloatImage {
  const { fogColor = lerp(FOG.gray, FOG.haze, haze) } = frame;
  return frame.image.map((x, y) => {
    const opacity = frame.isCovered(x, y) ? 1 - Math.exp(-length(frame.eventOffset(x, y)) / path) : overSky;
    const light = fogColor === 'sky' ? backdrop(frame, x, y, SKY_SHAPE.curve) : fogColor;
    return lerp(frame.image.at(x, y) as unknown as Vec3, scale(light, brightness), opacity);
  });
}
