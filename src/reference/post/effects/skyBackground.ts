import { dot, length, lerp, scale, type Vec3 } from '../../../math/vec3.ts';
import { SKY_SHAPE } from '../../../scene/lights/skyGradient.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

/**
 * A clear day's sky where no surface is, at rest in the world: aberration applies to it as to a sky, but as a backdrop it has no Doppler shift. Its colours are those of the scene's sky, if that is a gradient.
 * Surfaces fade into it, or into a colour of their own, by 1 − exp(−r/L), r = |Δx| the distance that their light has travelled in the world frame. arg1: brightness of both; arg2: exponent of
 * n·zenith for the blend from the colour of the horizon to that of the zenith; arg3: L [m], 0: no fading; arg4: opacity.
 * After the background of Zhu, Liu and Xia 2024 (docs/physics.md §14).
 */
export function skyBackground(
  frame: GBufferReader,
  [brightness = 1, power = 0.5, fade = 0, opacity = 1]: readonly number[],
): FloatImage {
  const { fogColor = 'sky' } = frame;
  return frame.image.map((x, y) => {
    const covered = frame.isCovered(x, y);
    const light = covered && fogColor !== 'sky' ? fogColor : backdrop(frame, x, y, power);
    const behind = fade > 0 ? 1 - Math.exp(-length(frame.eventOffset(x, y)) / fade) : 0;
    return lerp(frame.image.at(x, y) as unknown as Vec3, scale(light, brightness), opacity * (covered ? behind : 1));
  });
}

/** The sky in the direction that a pixel shows: of the shape `SKY_SHAPE` with its own exponent `curve`. */
export function backdrop(frame: GBufferReader, x: number, y: number, curve: number): Vec3 {
  const { zenith, horizon, ground } = frame.sky;
  const height = dot(frame.direction(x, y), frame.zenith);
  const { dim, haze, seam } = SKY_SHAPE;
  const above = lerp(horizon, zenith, Math.min(Math.max(height, 0), 1) ** curve);
  const below = lerp(scale(horizon, dim), ground, smoothstep(0, haze, -height));
  return lerp(below, above, smoothstep(-seam, seam, height));
}

function smoothstep(from: number, to: number, x: number): number {
  const t = Math.min(Math.max((x - from) / (to - from), 0), 1);
  return t * t * (3 - 2 * t);
}
