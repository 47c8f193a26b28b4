import type { FloatImage, GBufferReader } from './effectInput.ts';

const BINOMIAL = [1, 2, 1];

/**
 * I + k (I − B) with B the picture filtered by a 3 × 3 binomial, clamped to the range of the nine pixels enlarged by the overshoot, and never below 0:
 * without overshoot there are no halos. arg1: k; arg2: overshoot, as a fraction of the range.
 */
export function sharpen({ image }: GBufferReader, [strength = 0, overshoot = 0]: readonly number[]): FloatImage {
  return image.map((x, y) => {
    const here = image.at(x, y);
    const around = [-1, 0, 1].flatMap((j) =>
      [-1, 0, 1].map((i) => ({ weight: (BINOMIAL[i + 1]! * BINOMIAL[j + 1]!) / 16, texel: image.at(x + i, y + j) })),
    );
    return here.map((value, c) => {
      const blurred = around.reduce((sum, { weight, texel }) => sum + weight * texel[c]!, 0);
      const values = around.map(({ texel }) => texel[c]!);
      const [min, max] = [Math.min(...values), Math.max(...values)];
      const slack = overshoot * (max - min);
      const sharp = value + strength * (value - blurred);
      return Math.min(Math.max(sharp, min - slack, 0), max + slack);
    });
  });
}
