import { radians } from '../../../math/angle.ts';
import { GAUSSIAN_CUTOFF } from '../../../scene/frameGraph/effects.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

/**
 * A Gaussian along one direction: Σ_k w_k I(p + k e), w_k ∝ exp(−(k s)²/2σ²), cut off at 3 σ, Σ w = 1. The step e, of length s, leads to the next
 * column (or row, whichever axis is closer to the direction); within a column (row) the picture is interpolated linearly.
 * arg1: σ [px]; arg2: angle from the right, counterclockwise [°].
 */
export function gaussianBlur({ image }: GBufferReader, [sigma = 0, degrees = 0]: readonly number[]): FloatImage {
  const angle = radians(degrees);
  const [right, down] = [Math.cos(angle), -Math.sin(angle)];
  const across = Math.abs(right) >= Math.abs(down);
  const slope = across ? down / right : right / down;
  const spacing = 1 / (across ? Math.abs(right) : Math.abs(down));
  const weights = gaussianWeights(sigma, spacing);
  return image.map((x, y) => {
    const sum = [0, 0, 0];
    weights.forEach((weight, i) => {
      const k = i - (weights.length >> 1);
      const offset = k * slope;
      const near = Math.floor(offset);
      const fraction = offset - near;
      for (const [n, w] of [
        [near, 1 - fraction],
        [near + 1, fraction],
      ] as const) {
        const texel = across ? image.at(x + k, y + n) : image.at(x + n, y + k);
        for (let c = 0; c < 3; c++) sum[c]! += weight * w * texel[c]!;
      }
    });
    return sum;
  });
}

/** w_−r … w_r for taps at a distance of `spacing` [px]. */
export function gaussianWeights(sigma: number, spacing: number): readonly number[] {
  const width = Math.max(sigma, 1e-3);
  const reach = Math.ceil((GAUSSIAN_CUTOFF * width) / spacing - 1e-3);
  const raw = Array.from({ length: 2 * reach + 1 }, (_, i) => Math.exp(-0.5 * (((i - reach) * spacing) / width) ** 2));
  const sum = raw.reduce((a, b) => a + b);
  return raw.map((w) => w / sum);
}
