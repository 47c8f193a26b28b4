import { dot, length, lerp, scale, type Vec3 } from '../../../math/vec3.ts';
import { SKY_SHAPE, type SkyColors } from '../../../scene/lights/skyGradient.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

/**
 * A clear day's sky where no surface is, at rest in the world: aberration applies to it as to a sky, but as a backdrop it has no Doppler shift. Its colours are those of the scene's sky, if that is a gradient.
 * Surfaces fade into it by 1 − exp(−r/L), r = |Δx| the distance that their light has travelled in the world frame. arg1: brightness; arg2: exponent of
 * n·zenith for the blend from the colour of the horizon to that of the zenith; arg3: L [m], 0: no fading; arg4: opacity.
 * After the background of Zhu, Liu and Xia 2024 (docs/physics.md §14).
 */
export function skyBackground(
  frame: GBufferReader,
  [brightness = 1, power = 0.5, fade = 0, opacity = 1]: readonly number[],
): FloatImage {
  return frame.image.map((x, y) => {
    const sky = scale(backdrop(dot(frame.direction(x, y), frame.zenith), power, frame.sky), brightness);
    const behind = fade > 0 ? 1 - Math.exp(-length(frame.eventOffset(x, y)) / fade) : 0;
    const amount = opacity * (frame.isCovered(x, y) ? behind : 1);
    return lerp(frame.image.at(x, y) as unknown as Vec3, sky, amount);
  });
}

/** A sky of the shape `SKY_SHAPE` with its own exponent `curve`. */
function backdrop(height: number, curve: number, { zenith, horizon, ground }: SkyColors): Vec3 {
  const { dim, haze, seam } = SKY_SHAPE;
  const above = lerp(horizon, zenith, Math.min(Math.max(height, 0), 1) ** curve);
  const below = lerp(scale(horizon, dim), ground, smoothstep(0, haze, -height));
  return lerp(below, above, smoothstep(-seam, seam, height));
}

function smoothstep(from: number, to: number, x: number): number {
  const t = Math.min(Math.max((x - from) / (to - from), 0), 1);
  return t * t * (3 - 2 * t);
}
