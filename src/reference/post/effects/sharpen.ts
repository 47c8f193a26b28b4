import type { FloatImage, GBufferReader } from './effectInput.ts';

const BINOMIAL = [1, 2, 1];

/**
 * I + k (I − B), B the picture under a 3 × 3 binomial, kept between the least and the most of the nine pixels, or as far outside of them as told, and never below 0:
 * without overshoot no halo appears. arg1: k; arg2: overshoot, as a share of their range.
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
      const [least, most] = [Math.min(...values), Math.max(...values)];
      const slack = overshoot * (most - least);
      const sharp = value + strength * (value - blurred);
      return Math.min(Math.max(sharp, least - slack, 0), most + slack);
    });
  });
}
