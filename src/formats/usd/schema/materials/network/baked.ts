import { encodeSrgb } from '../../../../../spectrum/display/srgb.ts';
import type { DecodedImage } from '../../../../image/decodeImage.ts';
import type { TexelField } from './expression.ts';

/** Maximum number of steps in which a picture is computed: it is made smaller until it fits. */
const MAX_STEPS = 2 ** 26;

/** A computed picture, whose texels are to be multiplied by `gain`. */
export interface BakedImage {
  readonly image: DecodedImage;
  readonly gain: readonly number[];
}

/**
 * Computes an expression at every texel, as bytes: components 0 … 2 in the colour space, alpha 255. A single number is
 * in all three. Values below 0 become 0; `gain` is the greatest of each component, at least 1.
 */
export function bakedImage(texels: TexelField, colorSpace: 'srgb' | 'linear'): BakedImage {
  const { grid, size, cost } = texels;
  const shrink = 2 ** Math.ceil(Math.max(0, Math.log2((cost * grid.width * grid.height) / MAX_STEPS)) / 2);
  const [width, height] = [grid.width, grid.height].map((side) => Math.max(1, Math.floor(side / shrink)));
  const values = new Float32Array(3 * width * height);
  const gain = [1, 1, 1];
  for (let y = 0, i = 0; y < height; y++)
    for (let x = 0; x < width; x++, i += 3) {
      const at = texels.at(nearest(x, width, grid.width), nearest(y, height, grid.height));
      for (let k = 0; k < 3; k++) {
        const value = at[size === 1 ? 0 : k] ?? 0;
        values[i + k] = value > 0 && value < Infinity ? value : 0;
        gain[k] = Math.max(gain[k], values[i + k]);
      }
    }
  const data = new Uint8Array(4 * width * height).fill(255);
  for (let i = 0; i < width * height; i++)
    for (let k = 0; k < 3; k++) {
      const x = values[3 * i + k] / gain[k];
      data[4 * i + k] = Math.round(255 * (colorSpace === 'srgb' ? encodeSrgb(x) : x));
    }
  return { image: { width, height, data }, gain };
}

const nearest = (i: number, count: number, of: number): number => Math.floor(((i + 0.5) * of) / count);
