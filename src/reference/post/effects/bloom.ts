import { BLOOM_LEVELS } from '../../../scene/frameGraph/effects.ts';
import { FloatImage, type GBufferReader } from './effectInput.ts';

/**
 * Light that a lens or an eye scatters: (1 − s) I + s G I, G a glare of many widths with ∫ G = 1, so that light goes astray but none is made; no threshold, for
 * scattering knows none. G: the picture halved six times by the B-spline [1 3 3 1]/8, and brought back up by the same (its transpose), at each level
 * (1 − q) of its own and q of what is wider. Up is a mean of texels (U, rows of 1); down is its transpose, with the measure μ of how many pixels a texel stands
 * for: μ′ = Uᵀ μ, I′ = Uᵀ μ I/μ′. So G is symmetric, and keeps both an even picture and the sum of any, whatever the sizes. arg1: s; arg2: q.
 */
export function bloom({ image }: GBufferReader, [scattered = 0, spread = 0]: readonly number[]): FloatImage {
  const levels = [image.map((x, y) => [...image.at(x, y), 1], 4)];
  for (let k = 0; k < BLOOM_LEVELS; k++) levels.push(halved(levels[k]!));
  let wide = levels[BLOOM_LEVELS]!;
  for (let k = BLOOM_LEVELS - 1; k > 0; k--) wide = blend(levels[k]!, wide, spread);
  return blend(image, wide, scattered);
}

const blend = (near: FloatImage, wide: FloatImage, share: number): FloatImage =>
  near.map((x, y) => {
    const up = doubled(wide, x, y);
    const [r = 0, g = 0, b = 0] = near.at(x, y).map((value, c) => value + share * (up[c]! - value));
    return [r, g, b];
  });

/** (colour, μ/4ᵏ), from the 4 × 4 texels that take from this one on the way up. */
function halved(from: FloatImage): FloatImage {
  const [width, height] = [Math.ceil(from.width / 2), Math.ceil(from.height / 2)];
  const make = (x: number, y: number): readonly number[] => {
    const sum = [0, 0, 0];
    let measure = 0;
    for (let j = 2 * y - 1; j < 2 * y + 3; j++)
      for (let i = 2 * x - 1; i < 2 * x + 3; i++) {
        const [r, g, b, mu] = from.at(i, j) as [number, number, number, number];
        const weight = upsampleWeight(i, x, from.width) * upsampleWeight(j, y, from.height) * mu;
        [r, g, b].forEach((value, c) => {
          sum[c]! += weight * value;
        });
        measure += weight;
      }
    return [...sum.map((value) => value / measure), measure / 4];
  };
  return FloatImage.of(width, height, 4, make);
}

/** How much of the texel `coarse` the texel `fine` takes on the way up, along one side of `n` fine ones: ¾ of the one over it, ¼ of the next that there is. */
function upsampleWeight(fine: number, coarse: number, n: number): number {
  if (fine < 0 || fine >= n) return 0;
  const own = Math.floor(fine / 2);
  const next = Math.min(Math.max(own + (fine % 2 ? 1 : -1), 0), Math.ceil(n / 2) - 1);
  return (own === coarse ? 0.75 : 0) + (next === coarse ? 0.25 : 0);
}

/** The pixel (x, y) of a picture of twice the size. */
function doubled(from: FloatImage, x: number, y: number): readonly number[] {
  const [i, j] = [x >> 1, y >> 1];
  const [ni, nj] = [x % 2 ? i + 1 : i - 1, y % 2 ? j + 1 : j - 1];
  const [own, beside, below, corner] = [from.at(i, j), from.at(ni, j), from.at(i, nj), from.at(ni, nj)];
  return own.map((value, c) => (9 * value + 3 * (beside[c]! + below[c]!) + corner[c]!) / 16);
}
