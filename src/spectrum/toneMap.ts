import type { Vec3 } from '../math/vec3.ts';

/**
 * Khronos PBR Neutral: colours up to `shoulder` are kept as they are, brighter ones are compressed below 1 and fade to white.
 * Source: github.com/KhronosGroup/ToneMapping, PBR_Neutral/README.md (2024).
 */
export const NEUTRAL = { fresnel: 0.04, shoulder: 0.76, desaturation: 0.15, brightest: 1e15 } as const;

/**
 * Linear sRGB radiance → linear sRGB to display, each in 0…1 (still to be encoded): times 2^exposure [EV], then PBR Neutral.
 * Negative input counts as 0.
 */
export function toneMap(rgb: Vec3, exposure: number): Vec3 {
  const exposed = (value: number) => Math.min(Math.max(value * 2 ** exposure, 0), NEUTRAL.brightest);
  const color: Vec3 = [exposed(rgb[0]), exposed(rgb[1]), exposed(rgb[2])];
  const least = Math.min(...color);
  const offset = least < 2 * NEUTRAL.fresnel ? least - least ** 2 / (4 * NEUTRAL.fresnel) : NEUTRAL.fresnel;
  const peak = Math.max(...color) - offset;
  if (peak <= NEUTRAL.shoulder) return [color[0] - offset, color[1] - offset, color[2] - offset];
  const room = 1 - NEUTRAL.shoulder;
  const newPeak = 1 - room ** 2 / (peak + room - NEUTRAL.shoulder);
  const white = 1 - 1 / (NEUTRAL.desaturation * (peak - newPeak) + 1);
  const compressed = (value: number) => ((value - offset) * newPeak * (1 - white)) / peak + newPeak * white;
  return [compressed(color[0]), compressed(color[1]), compressed(color[2])];
}
