import { BLOOM_LEVELS } from '../../scene/effects.ts';
import { type Frame, Plane } from './frame.ts';

const SPLINE = [1, 3, 3, 1];

/**
 * Light that a lens or an eye scatters: (1 − s) I + s G I, G a glare of many widths with ∫ G = 1, so that light goes astray but none is made; no threshold, for
 * scattering knows none. G: the picture halved six times by the B-spline [1 3 3 1]/8, and brought back up by the same (its transpose), at each level
 * (1 − q) of its own and q of what is wider. Exact in what it keeps where both sides of the picture are multiples of 64. arg1: s; arg2: q.
 */
export function bloom({ image }: Frame, [scattered = 0, spread = 0]: readonly number[]): Plane {
  const levels = [image];
  for (let k = 0; k < BLOOM_LEVELS; k++) levels.push(halved(levels[k]!));
  let wide = levels[BLOOM_LEVELS]!;
  for (let k = BLOOM_LEVELS - 1; k > 0; k--) wide = blend(levels[k]!, wide, spread);
  return blend(image, wide, scattered);
}

const blend = (near: Plane, wide: Plane, share: number): Plane =>
  near.map((x, y) => {
    const up = doubled(wide, x, y);
    return near.at(x, y).map((value, c) => value + share * (up[c]! - value));
  });

function halved(from: Plane): Plane {
  return Plane.of(Math.ceil(from.width / 2), Math.ceil(from.height / 2), 3, (x, y) => {
    const sum = [0, 0, 0];
    for (let j = 0; j < 4; j++)
      for (let i = 0; i < 4; i++)
        from.at(2 * x - 1 + i, 2 * y - 1 + j).forEach((value, c) => {
          sum[c]! += (SPLINE[i]! * SPLINE[j]! * value) / 64;
        });
    return sum;
  });
}

/** The pixel (x, y) of a picture of twice the size: ¾ of the texel over it and ¼ of the next, both ways. */
function doubled(from: Plane, x: number, y: number): readonly number[] {
  const [i, j] = [x >> 1, y >> 1];
  const [ni, nj] = [x % 2 ? i + 1 : i - 1, y % 2 ? j + 1 : j - 1];
  const [own, beside, below, corner] = [from.at(i, j), from.at(ni, j), from.at(i, nj), from.at(ni, nj)];
  return own.map((value, c) => (9 * value + 3 * (beside[c]! + below[c]!) + corner[c]!) / 16);
}
