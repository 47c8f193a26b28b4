import { addScaled, lerp, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import type { SkyGradient } from './light.ts';

/** Radiance of the zenith, the horizon and the ground. */
export interface SkyColors extends SkyGradient {
  readonly zenith: Vec3;
}

/**
 * By height h = n·zenith: above, horizon → zenith as h^curve; below, a haze of the horizon's colour that fades to the
 * ground within `haze`; the two meet within ±`seam`.
 */
export const SKY_SHAPE = { curve: 0.45, dim: 0.8, haze: 0.35, seam: 0.015 } as const;

/** Radiance at the height h = n·zenith, −1 … 1. */
export function gradientAt(h: number, { zenith, horizon, ground }: SkyColors): Vec3 {
  const { curve, dim, haze, seam } = SKY_SHAPE;
  const above = lerp(horizon, zenith, Math.max(h, 0) ** curve);
  const below = lerp(scale(horizon, dim), ground, smoothstep(0, haze, -h));
  return lerp(below, above, smoothstep(-seam, seam, h));
}

export function smoothstep(from: number, to: number, x: number): number {
  const s = Math.min(Math.max((x - from) / (to - from), 0), 1);
  return s * s * (3 - 2 * s);
}

/** Irradiance/π on a surface whose normal is at the height c, nearly: level + rise c + bend c². */
export interface SkyIrradiance {
  readonly level: Vec3;
  readonly rise: Vec3;
  readonly bend: Vec3;
}

const STEPS = 512;

/**
 * The irradiance of a sky that depends on height only; exact for surfaces that face up, down and the horizon. Terms beyond the parabola are small for every sky
 * (Ramamoorthi and Hanrahan 2001, "An efficient representation for irradiance environment maps", §3.2).
 */
export function skyIrradiance(sky: SkyColors): SkyIrradiance {
  let [up, side, down]: readonly Vec3[] = [ZERO, ZERO, ZERO];
  for (let i = 0; i < STEPS; i++) {
    const h = (2 * (i + 0.5)) / STEPS - 1;
    const radiance = gradientAt(h, sky);
    // 2 ∫ L h dh over each half, and (2/π) ∫ L √(1 − h²) dh towards the horizon.
    up = addScaled(up, radiance, (4 / STEPS) * Math.max(h, 0));
    down = addScaled(down, radiance, (4 / STEPS) * Math.max(-h, 0));
    side = addScaled(side, radiance, (4 / (Math.PI * STEPS)) * Math.sqrt(1 - h * h));
  }
  return { level: side, rise: scale(sub(up, down), 0.5), bend: sub(lerp(up, down, 0.5), side) };
}
