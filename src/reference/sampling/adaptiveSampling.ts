import { add, scale, type Vec3, ZERO } from '../../math/vec3.ts';

/**
 * Adaptive sampling: pixels get samples until the noise that is left is small, so that samples go where noise is.
 * @example
 * const adaptive: AdaptiveSampling = { noiseThreshold: 0.02, minSamples: 3 };
 */
export interface AdaptiveSampling {
  /**
   * The noise ε of blocks of 4 × 4 pixels that get all samples; others end below it. Noise is the root mean square of the pixels' standard errors: of
   * `picture` in sRGB values, 0 … 1; of `beauty` relative to the mean radiance of the block. 0: every pixel gets all samples that it may.
   */
  readonly noiseThreshold: number;
  /** n, for n × n samples per pixel at least, but no more than without adaptive sampling. */
  readonly minSamples: number;
}

/**
 * The noise at which N of at most M samples are enough: ε √(N/M). With the noise σ/√N of N samples they end at N ∝ σ, which for a given sum of N has
 * the least mean square error; with the same limit ε for all it would be N ∝ σ², which is no better than N = const.
 * Source: Neyman 1934, "On the two different aspects of the representative method", J. R. Stat. Soc. 97, for strata.
 */
export const noiseLimit = ({ noiseThreshold }: AdaptiveSampling, count: number, samples: number): number =>
  noiseThreshold * Math.sqrt(count / samples ** 2);

/**
 * Numbers of samples after which the error is estimated, and the most at the end: 2ᵏ and 3 · 2ᵏ, at which a pixel's sequence consists of whole
 * elementary intervals (`pixelSequence`).
 */
export function sampleCounts({ minSamples }: AdaptiveSampling, samples: number): readonly number[] {
  const most = samples ** 2;
  const counts: number[] = [];
  for (let k = 2; k < most; k *= 2) counts.push(k, 1.5 * k);
  return [...counts.filter((count) => count >= minSamples ** 2 && count < most), most];
}

/**
 * Variance of the mean of N = 2ᵏ or 3 · 2ᵏ samples in each channel, from the means of 2 or 3 equal parts of the sequence: s²/n. Parts are
 * stratified too, so this is not the error of independent samples but, where the integrand is smooth, a much smaller one.
 * `meanOf` gives the mean of the samples from … to.
 */
export function varianceOfMean(count: number, meanOf: (from: number, to: number) => Vec3): Vec3 {
  const parts = Number.isInteger(Math.log2(count)) ? 2 : 3;
  const size = count / parts;
  const means = Array.from({ length: parts }, (_, k) => meanOf(k * size, (k + 1) * size));
  const mean = scale(means.reduce(add, ZERO), 1 / parts);
  const square = ([r, g, b]: Vec3): Vec3 => [(r - mean[0]) ** 2, (g - mean[1]) ** 2, (b - mean[2]) ** 2];
  return scale(means.map(square).reduce(add, ZERO), 1 / (parts * (parts - 1)));
}
