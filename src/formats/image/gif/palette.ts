/** Colours of a picture: how often each 6-bit colour occurs, and the sums of what is rounded to it. */
export interface ColorHistogram {
  readonly counts: Float32Array;
  /** r, g, b per colour, of 8 bits each. */
  readonly sums: Float32Array;
}

/** Red, green, blue of each colour, 0 … 255. */
export type Palette = Uint8Array;

/** Weights of squared differences in red, green and blue: about the eye's sensitivity to each in sRGB. */
export const CHANNEL_WEIGHTS = [2, 4, 1] as const;

const COLORS = 1 << 18;
/** Rounds of improvement: each colour becomes the mean of those that are nearest to it. */
const MEAN_ROUNDS = 3;

export const emptyHistogram = (): ColorHistogram => ({
  counts: new Float32Array(COLORS),
  sums: new Float32Array(3 * COLORS),
});

/** Adds the pixels (RGBA8) of a picture, of which every `stride`-th counts. */
export function addPixels({ counts, sums }: ColorHistogram, rgba: Uint8Array, stride: number): void {
  for (let i = 0; i < rgba.length; i += 4 * stride) {
    const r = rgba[i];
    const g = rgba[i + 1];
    const b = rgba[i + 2];
    const color = ((r >> 2) << 12) | ((g >> 2) << 6) | (b >> 2);
    counts[color]++;
    sums[3 * color] += r;
    sums[3 * color + 1] += g;
    sums[3 * color + 2] += b;
  }
}

/** Multiplies all counts, so that what is added later weighs more. */
export function fadeHistogram({ counts, sums }: ColorHistogram, factor: number): void {
  for (let i = 0; i < counts.length; i++) counts[i] *= factor;
  for (let i = 0; i < sums.length; i++) sums[i] *= factor;
}

/** Distinct colours as points, with weights that let small bright parts have colours of their own. */
interface ColorPoints {
  readonly rgb: Float64Array;
  readonly weights: Float64Array;
}

function pointsOf({ counts, sums }: ColorHistogram): ColorPoints {
  const colors: number[] = [];
  // What has faded away no longer counts.
  for (let color = 0; color < COLORS; color++) if (counts[color] > 0.02) colors.push(color);
  return {
    rgb: Float64Array.from({ length: 3 * colors.length }, (_, i) => {
      const color = colors[Math.floor(i / 3)];
      return sums[3 * color + (i % 3)] / counts[color];
    }),
    weights: Float64Array.from(colors, (color) => Math.sqrt(counts[color])),
  };
}

/**
 * At most `size` colours that represent a picture: the set of its colours is cut at the mean of its most varied channel,
 * always the part with the largest squared error (Wu 1991, "Efficient Statistical Computations for Optimal Color
 * Quantization"), and then improved by means (Lloyd 1982).
 */
export function choosePalette(histogram: ColorHistogram, size: number): Palette {
  const points = pointsOf(histogram);
  const parts = [partOf(points, Array.from(points.weights.keys()))];
  while (parts.length < size) {
    const worst = parts.reduce((a, b) => (b.error > a.error ? b : a));
    if (!(worst.error > 0)) break;
    const { members, channel, mean } = worst;
    const low = members.filter((i) => points.rgb[3 * i + channel] <= mean[channel]);
    const high = members.filter((i) => points.rgb[3 * i + channel] > mean[channel]);
    parts.splice(parts.indexOf(worst), 1, partOf(points, low), partOf(points, high));
  }
  const palette = Uint8Array.from(parts.flatMap(({ mean }) => mean.map(Math.round)));
  for (let round = 0; round < MEAN_ROUNDS; round++) moveToMeans(palette, points);
  return palette;
}

interface Part {
  readonly members: readonly number[];
  readonly mean: readonly number[];
  /** The channel that varies most. */
  readonly channel: number;
  /** Weighted squared error of that channel; 0 if it cannot be cut. */
  readonly error: number;
}

function partOf({ rgb, weights }: ColorPoints, members: readonly number[]): Part {
  let total = 0;
  const [sum, square] = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  for (const i of members) {
    total += weights[i];
    for (let k = 0; k < 3; k++) {
      sum[k] += weights[i] * rgb[3 * i + k];
      square[k] += weights[i] * rgb[3 * i + k] ** 2;
    }
  }
  const mean = sum.map((value) => value / total);
  const errors = square.map((value, k) => CHANNEL_WEIGHTS[k] * (value - total * mean[k] ** 2));
  const error = Math.max(...errors);
  // Below that rounding errors remain.
  return { members, mean, channel: errors.indexOf(error), error: error > 1e-6 * total ? error : 0 };
}

function moveToMeans(palette: Palette, { rgb, weights }: ColorPoints): void {
  const sums = new Float64Array((palette.length / 3) * 4);
  for (let i = 0; i < weights.length; i++) {
    const nearest = nearestColor(palette, rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
    sums[4 * nearest] += weights[i];
    for (let k = 0; k < 3; k++) sums[4 * nearest + 1 + k] += weights[i] * rgb[3 * i + k];
  }
  for (let j = 0; j < palette.length; j++) {
    const part = 4 * Math.floor(j / 3);
    if (sums[part] > 0) palette[j] = Math.round(sums[part + 1 + (j % 3)] / sums[part]);
  }
}

/** Index of the nearest colour of a palette; r, g, b may lie outside of 0 … 255. */
export function nearestColor(palette: Palette, r: number, g: number, b: number): number {
  let [nearest, least] = [0, Number.POSITIVE_INFINITY];
  for (let j = 0; j < palette.length; j += 3) {
    const distance = colorDistance(palette, j, r, g, b);
    if (distance >= least) continue;
    least = distance;
    nearest = j;
  }
  return nearest / 3;
}

/** Weighted squared distance of the palette's colour at offset j. */
export function colorDistance(palette: ArrayLike<number>, j: number, r: number, g: number, b: number): number {
  const dr = palette[j] - r;
  const dg = palette[j + 1] - g;
  const db = palette[j + 2] - b;
  return CHANNEL_WEIGHTS[0] * dr * dr + CHANNEL_WEIGHTS[1] * dg * dg + CHANNEL_WEIGHTS[2] * db * db;
}

/** Mean weighted squared distance of a picture's colours to a palette. */
export function paletteError(palette: Palette, histogram: ColorHistogram): number {
  const { rgb, weights } = pointsOf(histogram);
  let [sum, total] = [0, 0];
  for (let i = 0; i < weights.length; i++) {
    const [r, g, b] = [rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]];
    sum += weights[i] * colorDistance(palette, 3 * nearestColor(palette, r, g, b), r, g, b);
    total += weights[i];
  }
  return total === 0 ? 0 : sum / total;
}
