import type { Vec3 } from '../math/vec3.ts';

/**
 * The shoulder of Khronos PBR Neutral: colours up to `shoulder` are kept as they are, brighter ones are compressed below 1 and
 * fade to white. Its toe, which takes off the 4 % that a product photograph reflects, is left out: it turns the faint light of
 * things that flee to black. Source: github.com/KhronosGroup/ToneMapping, PBR_Neutral/README.md (2024).
 */
export const NEUTRAL = { shoulder: 0.8, desaturation: 0.15, brightest: 1e15 } as const;

/**
 * Linear sRGB radiance → linear sRGB to display, each in 0…1 (still to be encoded): times 2^exposure [EV], then the shoulder.
 * Negative input counts as 0.
 */
export function toneMap(rgb: Vec3, exposure: number): Vec3 {
  const exposed = (value: number) => Math.min(Math.max(value * 2 ** exposure, 0), NEUTRAL.brightest);
  const color: Vec3 = [exposed(rgb[0]), exposed(rgb[1]), exposed(rgb[2])];
  const peak = Math.max(...color);
  if (peak <= NEUTRAL.shoulder) return color;
  const room = 1 - NEUTRAL.shoulder;
  const newPeak = 1 - room ** 2 / (peak + room - NEUTRAL.shoulder);
  const white = 1 - 1 / (NEUTRAL.desaturation * (peak - newPeak) + 1);
  const compressed = (value: number) => (value * newPeak * (1 - white)) / peak + newPeak * white;
  return [compressed(color[0]), compressed(color[1]), compressed(color[2])];
}
