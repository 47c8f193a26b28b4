import { BLOOM_LEVELS } from '../../../scene/frameGraph/effects.ts';
import { FloatImage, type GBufferReader } from './effectInput.ts';

/**
 * Light scattered in a lens or an eye: (1 − s) I + s G I with a glare G of many widths and ∫ G = 1, so that light is conserved; no threshold, since
 * scattering has none. G: the picture is downsampled six times by the B-spline [1 3 3 1]/8 and upsampled by its transpose, at each level blending
 * (1 − q) of its own with q of the wider levels. Upsampling U is a mean of texels (rows sum to 1); downsampling is its transpose, weighted by the
 * number μ of pixels that a texel stands for: μ′ = Uᵀ μ, I′ = Uᵀ μ I/μ′. So G is symmetric, and preserves constant pictures and the sum of all
 * pixels, at any size. arg1: s; arg2: q. docs/physics.md §8.4.
 */
export function bloom({ image }: GBufferReader, [scattered = 0, spread = 0]: readonly number[]): FloatImage {
  const levels = [image.map((x, y) => [...image.at(x, y), 1], 4)];
  for (let k = 0; k < BLOOM_LEVELS; k++) levels.push(downsample(levels[k]!));
  let wide = levels[BLOOM_LEVELS]!;
  for (let k = BLOOM_LEVELS - 1; k > 0; k--) wide = blend(levels[k]!, wide, spread);
  return blend(image, wide, scattered);
}

const blend = (near: FloatImage, wide: FloatImage, wideWeight: number): FloatImage =>
  near.map((x, y) => {
    const up = upsampled(wide, x, y);
    const [r = 0, g = 0, b = 0] = near.at(x, y).map((value, c) => value + wideWeight * (up[c]! - value));
    return [r, g, b];
  });

/** The next level, (colour, μ/4ᵏ), from the 4 × 4 texels that a texel contributes to in upsampling. */
function downsample(from: FloatImage): FloatImage {
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

/** Weight of the texel `coarse` in the upsampled texel `fine`, along one axis of `n` fine texels: ¾ for the one that contains it, ¼ for the nearest other one. */
function upsampleWeight(fine: number, coarse: number, n: number): number {
  if (fine < 0 || fine >= n) return 0;
  const own = Math.floor(fine / 2);
  const next = Math.min(Math.max(own + (fine % 2 ? 1 : -1), 0), Math.ceil(n / 2) - 1);
  return (own === coarse ? 0.75 : 0) + (next === coarse ? 0.25 : 0);
}

/** The pixel (x, y) of the picture upsampled to twice the size. */
function upsampled(from: FloatImage, x: number, y: number): readonly number[] {
  const [i, j] = [x >> 1, y >> 1];
  const [ni, nj] = [x % 2 ? i + 1 : i - 1, y % 2 ? j + 1 : j - 1];
  const [own, beside, below, corner] = [from.at(i, j), from.at(ni, j), from.at(i, nj), from.at(ni, nj)];
  return own.map((value, c) => (9 * value + 3 * (beside[c]! + below[c]!) + corner[c]!) / 16);
}
