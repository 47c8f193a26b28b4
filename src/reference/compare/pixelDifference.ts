import type { RgbImage } from './rgbImage.ts';

export interface PixelDifference {
  /** Per pixel, the largest |A − B| of the three channels. */
  readonly map: Float32Array;
  /** Mean |A − B| over all channels of all pixels. */
  readonly mean: number;
  readonly max: number;
  /** √mean(A − B)² */
  readonly rmse: number;
  /** Peak signal-to-noise ratio, 20 log₁₀(peak/RMSE) [dB]; infinite if nothing differs. */
  readonly psnr: number;
}

/** Absolute differences in the pictures' own units. `peak` is the largest possible value: 1 for display values. Symmetric. */
export function pixelDifference(a: RgbImage, b: RgbImage, peak: number): PixelDifference {
  const map = new Float32Array(a.width * a.height);
  let [sum, squares, max] = [0, 0, 0];
  for (let i = 0; i < a.rgb.length; i++) {
    const error = Math.abs(a.rgb[i] - b.rgb[i]);
    const pixel = Math.floor(i / 3);
    map[pixel] = Math.max(map[pixel], error);
    sum += error;
    squares += error * error;
    max = Math.max(max, error);
  }
  const rmse = Math.sqrt(squares / a.rgb.length);
  return { map, mean: sum / a.rgb.length, max, rmse, psnr: 20 * Math.log10(peak / rmse) };
}
