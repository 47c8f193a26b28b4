import { luminance } from './colorSpaces.ts';
import { flip, PIXELS_PER_DEGREE } from './flip.ts';
import type { RgbImage } from './rgbImage.ts';

/**
 * ꟻLIP of high dynamic range pictures: per pixel, the largest over a series of exposures. Source: Andersson, Nilsson, Shirley &
 * Akenine-Möller, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics 2021 short papers.
 */
export interface HdrFlip {
  readonly map: Float32Array;
  readonly exposures: Exposures;
}

/** `count` equidistant exposures from `start` to `stop` [EV]. */
export interface Exposures {
  readonly start: number;
  readonly stop: number;
  readonly count: number;
}

/** Both pictures: linear light, sRGB primaries, unbounded. Not symmetric: the default exposures depend on the reference only. */
export function hdrFlip(
  test: RgbImage,
  reference: RgbImage,
  exposures = exposuresFor(reference),
  pixelsPerDegree = PIXELS_PER_DEGREE,
): HdrFlip {
  const { start, stop, count } = exposures;
  const map = new Float32Array(reference.width * reference.height);
  for (let n = 0; n < count; n++) {
    const exposure = count > 1 ? start + ((stop - start) * n) / (count - 1) : start;
    const errors = flip(exposed(test, exposure), exposed(reference, exposure), pixelsPerDegree);
    for (let i = 0; i < map.length; i++) map[i] = Math.max(map[i], errors[i]);
  }
  return { map, exposures };
}

/** Tone-mapped value at which a luminance counts as well exposed (section 3). */
const BRIGHT = 0.85;
/** Lower bound of luminance, so that black pictures have finite exposures. */
const DARKEST = 2 ** -23;

/** From the exposure at which the brightest pixel is tone mapped to `BRIGHT` to the one at which the median pixel is. */
export function exposuresFor(reference: RgbImage): Exposures {
  const luminances = Float32Array.from({ length: reference.rgb.length / 3 }, (_, i) => {
    const [r, g, b] = reference.rgb.subarray(3 * i, 3 * i + 3);
    return Math.max(luminance(r, g, b), DARKEST);
  }).sort();
  const exposureOf = (brightness: number) => Math.log2(inverseFilmic(BRIGHT) / brightness);
  const start = exposureOf(luminances[luminances.length - 1]);
  const stop = exposureOf(luminances[luminances.length >> 1]);
  return { start, stop, count: Math.max(2, Math.ceil(stop - start)) };
}

/** The ACES curve (k₀x² + k₁x)/(k₂x² + k₃x + k₄). Source: Narkowicz 2016, with the input scaled by 0.6 as in the paper. */
const CURVE = [2.51 * 0.6 ** 2, 0.03 * 0.6, 2.43 * 0.6 ** 2, 0.59 * 0.6, 0.14] as const;

function filmic(x: number): number {
  const [k0, k1, k2, k3, k4] = CURVE;
  return (k0 * x * x + k1 * x) / (k2 * x * x + k3 * x + k4);
}

/** The positive root of filmic(x) = y. */
function inverseFilmic(y: number): number {
  const [k0, k1, k2, k3, k4] = CURVE;
  const [a, b, c] = [k0 - y * k2, k1 - y * k3, -y * k4];
  return (-b + Math.sqrt(b * b - 4 * a * c)) / (2 * a);
}

function exposed({ width, height, rgb }: RgbImage, exposure: number): RgbImage {
  const factor = 2 ** exposure;
  return { width, height, rgb: rgb.map((value) => Math.min(filmic(Math.max(value, 0) * factor), 1)) };
}
