import { encodeSrgb } from '../../spectrum/display/srgb.ts';

/**
 * Encodes linear display values, 0 … 1, 3 per pixel, as RGBA8 in sRGB like the rasterizer, dithered by ± ½ step of interleaved gradient noise
 * against banding. Source: Jimenez 2014.
 */
export function encodeDisplay(linear: Float32Array, width: number, height: number): Uint8Array<ArrayBuffer> {
  const pixels = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = y * width + x;
      const noise = fraction(52.9829189 * fraction(0.06711056 * x + 0.00583715 * y)) - 0.5;
      for (let k = 0; k < 3; k++) pixels[4 * i + k] = toByte(255 * encodeSrgb(linear[3 * i + k]) + noise);
      pixels[4 * i + 3] = 255;
    }
  }
  return pixels;
}

const fraction = (x: number): number => x - Math.floor(x);
const toByte = (x: number): number => Math.min(Math.max(Math.round(x), 0), 255);
