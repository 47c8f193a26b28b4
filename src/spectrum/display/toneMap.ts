import type { Vec3 } from '../../math/vec3.ts';
import { agx } from './agx.ts';

/**
 * Tone curve from linear light to a display. `neutral` keeps colours unchanged up to a shoulder; `agx` compresses all of them as film
 * does; `linear` clips.
 */
export type ToneMapping = 'neutral' | 'agx' | 'linear';
export const TONE_MAPPINGS: readonly ToneMapping[] = ['neutral', 'agx', 'linear'];

/**
 * The shoulder of Khronos PBR Neutral: colours up to `shoulder` are unchanged, brighter ones are compressed below 1 and
 * fade to white. Its toe, which subtracts the 4 % Fresnel reflection of product photographs, is left out: it would turn the faint light of
 * receding objects black. docs/physics.md §8.1. Source: github.com/KhronosGroup/ToneMapping, PBR_Neutral/README.md (2024).
 */
export const NEUTRAL = { shoulder: 0.8, desaturation: 0.15 } as const;

/** Light is clamped to this before the curve, so that it stays finite. */
export const MAX_RADIANCE = 1e15;

/**
 * Linear sRGB radiance → linear sRGB to display, each in 0…1 (still to be encoded): times 2^exposure [EV], then the curve. Negative channels
 * (colours outside the gamut) are desaturated by `agx` and set to 0 by the others.
 * @example
 * toneMap([0.25, 0.5, 0.125], 0, 'neutral'); // [0.25, 0.5, 0.125]: below the shoulder
 * toneMap([0.25, 0.5, 0.125], 2, 'linear'); // [1, 1, 0.5]: two stops brighter, clipped
 */
export function toneMap(rgb: Vec3, exposure: number, tone: ToneMapping): Vec3 {
  const exposed = (value: number) => Math.min(Math.max(value * 2 ** exposure, -MAX_RADIANCE), MAX_RADIANCE);
  return CURVES[tone]([exposed(rgb[0]), exposed(rgb[1]), exposed(rgb[2])]);
}

const CURVES: Readonly<Record<ToneMapping, (rgb: Vec3) => Vec3>> = { neutral, agx, linear };

function neutral([r, g, b]: Vec3): Vec3 {
  const color: Vec3 = [Math.max(r, 0), Math.max(g, 0), Math.max(b, 0)];
  const peak = Math.max(...color);
  if (peak <= NEUTRAL.shoulder) return color;
  const room = 1 - NEUTRAL.shoulder;
  const newPeak = 1 - room ** 2 / (peak + room - NEUTRAL.shoulder);
  const white = 1 - 1 / (NEUTRAL.desaturation * (peak - newPeak) + 1);
  const compressed = (value: number) => (value * newPeak * (1 - white)) / peak + newPeak * white;
  return [compressed(color[0]), compressed(color[1]), compressed(color[2])];
}

function linear([r, g, b]: Vec3): Vec3 {
  const cut = (value: number) => Math.min(Math.max(value, 0), 1);
  return [cut(r), cut(g), cut(b)];
}

/** ln D over which a surface that emits its own colour goes over to the tone curve. */
export const UNLIT_RANGE = 0.1;

/** The share of `linear` in what is shown of a surface that emits its own colour (`Material.unlit`) and is seen with D: all at D = 1, so that it shows its colour. */
export const unlitShare = (D: number): number => Math.max(0, 1 - Math.abs(Math.log(D)) / UNLIT_RANGE);
