import type { Random } from '../../../math/random.ts';
import { dot, type Vec3 } from '../../../math/vec3.ts';
import { directionFromLatLong, domeAxes, latLongFromDirection } from '../../../scene/lights/latLong.ts';
import { linearizationTable } from '../../../scene/materials/sampleTexture.ts';
import type { DomeLight } from '../../../scene/types.ts';
import { LUMINANCE_WEIGHTS } from '../../../spectrum/color/observerColor.ts';

/** Importance sampler of the directions in which a sky is brighter than its mean. */
export interface SkySampler {
  /** Fraction of all sampled directions to take from this sampler, 0 … ½; the BRDF chooses the rest. */
  readonly probability: number;
  /** A random direction: unit, world. */
  sample(random: Random): Vec3;
  /** Probability density of `sample` at the unit world direction n [1/sr]. */
  pdf(n: Vec3): number;
}

/** Upper bound of the number of columns; larger pictures are averaged over blocks. */
const MAX_COLUMNS = 2048;
/** Upper bound of `probability`, so that at least half of the directions come from the BRDF. */
const MAX_PROBABILITY = 0.5;

/**
 * The sampler of a dome's texture; undefined if it has no bright parts. A texel's weight is max(luminance − mean, 0) times its solid angle, because
 * BRDF samples find the rest (Karlík et al. 2019, "MIS compensation", ACM TOG 38(6)). A row, then a texel of it, are found by inverting cumulative
 * sums, then a point around the texel by a tent distribution: the density is linear between texels, like the interpolated texture.
 */
export function skySampler(dome: DomeLight): SkySampler | undefined {
  const texels = texelsOf(dome);
  if (!texels) return undefined;
  const { width, height, excess, fraction } = texels;
  const [x, y, z] = domeAxes(dome);
  const rows = rowCdfs(excess, width, height);
  const marginal = cdfOf(rows.sums);
  const texelProbability = (column: number, row: number): number => {
    const j = Math.min(Math.max(row, 0), height - 1);
    const at = j * (width + 1) + ((column + width) % width);
    return (marginal[j + 1] - marginal[j]) * (rows.rising[at + 1] - rows.rising[at]);
  };
  return {
    probability: Math.min(fraction, MAX_PROBABILITY),
    sample: (random) => {
      const [row, down] = invertCdf(marginal, 0, height, random());
      const [column, right] = invertCdf(rows.rising, row * (width + 1), width, random());
      // Beyond a pole the texture repeats its last row.
      const v = Math.abs((row + 0.5 + tentOffset(down)) / height);
      const [a, b, c] = directionFromLatLong((column + 0.5 + tentOffset(right)) / width, 1 - Math.min(v, 2 - v));
      return [a * x[0] + b * y[0] + c * z[0], a * x[1] + b * y[1] + c * z[1], a * x[2] + b * y[2] + c * z[2]];
    },
    pdf: (n) => {
      const up = dot(n, y);
      const [u, v] = latLongFromDirection([dot(n, x), up, dot(n, z)]);
      const [i, j] = [u * width - 0.5, (1 - v) * height - 0.5];
      const [left, top] = [Math.floor(i), Math.floor(j)];
      const [s, t] = [i - left, j - top];
      const across = (row: number): number =>
        (1 - s) * texelProbability(left, row) + s * texelProbability(left + 1, row);
      const probability = (1 - t) * across(top) + t * across(top + 1);
      return (probability * width * height) / (2 * Math.PI ** 2 * Math.sqrt(Math.max(1 - up * up, 1e-12)));
    },
  };
}

/** Inverts the cumulative distribution of the density 1 − |x| on −1 … 1. */
const tentOffset = (p: number): number => (p < 0.5 ? Math.sqrt(2 * p) - 1 : 1 - Math.sqrt(2 - 2 * p));

interface TexelExcess {
  readonly width: number;
  readonly height: number;
  /** Power above the mean, per texel. */
  readonly excess: Float32Array;
  /** Sum of `excess` divided by the total power. */
  readonly fraction: number;
}

function texelsOf(dome: DomeLight): TexelExcess | undefined {
  const map = luminances(dome);
  if (!map) return undefined;
  const { width, height, values } = map;
  const sizes = Float64Array.from(
    { length: height },
    (_, row) => Math.cos((Math.PI * row) / height) - Math.cos((Math.PI * (row + 1)) / height),
  );
  let total = 0;
  for (let i = 0; i < values.length; i++) total += values[i] * sizes[Math.floor(i / width)];
  // `sizes` sum to 2, and each row has `width` texels.
  const mean = total / (2 * width);
  const excess = values.map((value, i) => Math.max(value - mean, 0) * sizes[Math.floor(i / width)]);
  const above = excess.reduce((sum, part) => sum + part, 0);
  const fraction = above / total;
  // Rounding errors of a uniform sky do not count as bright parts.
  return fraction > 1e-3 ? { width, height, excess, fraction } : undefined;
}

interface LuminanceMap {
  readonly width: number;
  readonly height: number;
  readonly values: Float32Array;
}

function luminances({ texture, color, blackbodies }: DomeLight): LuminanceMap | undefined {
  if (!texture) return undefined;
  const block = Math.ceil(texture.width / MAX_COLUMNS);
  const [width, height] = [Math.ceil(texture.width / block), Math.ceil(texture.height / block)];
  const [r, g, b] = (blackbodies ? [1, 1, 1] : LUMINANCE_WEIGHTS).map((part, k) => part * color[k]);
  const linear = linearizationTable(texture);
  const values = new Float32Array(width * height);
  const { data } = texture;
  for (let y = 0, i = 0; y < texture.height; y++)
    for (let x = 0; x < texture.width; x++, i += 4)
      values[Math.floor((y * height) / texture.height) * width + Math.floor((x * width) / texture.width)] +=
        (r * linear[data[i]] + g * linear[data[i + 1]] + b * linear[data[i + 2]]) / (block * block);
  return { width, height, values };
}

/** The cumulative distribution of each row, 0 … 1, and the sum of each row. */
function rowCdfs(values: Float32Array, width: number, height: number) {
  const all = new Float32Array((width + 1) * height);
  const sums = Float32Array.from({ length: height }, (_, row) => {
    const own = values.subarray(row * width, (row + 1) * width);
    all.set(cdfOf(own), row * (width + 1));
    return own.reduce((sum, value) => sum + value, 0);
  });
  return { rising: all, sums };
}

/** The cumulative distribution, 0 … 1, with one more entry than there are values; all 0 if they are. */
function cdfOf(values: Float32Array): Float32Array {
  const out = new Float32Array(values.length + 1);
  let sum = 0;
  const sumOfAll = values.reduce((total, value) => total + value, 0) || 1;
  values.forEach((value, i) => {
    sum += value;
    out[i + 1] = sum / sumOfAll;
  });
  return out;
}

/** The interval of a cumulative distribution, beginning at `start`, that contains p, and the position of p in it, 0 … 1. */
function invertCdf(
  sums: Float32Array,
  start: number,
  count: number,
  p: number,
): readonly [step: number, within: number] {
  let [low, high] = [0, count];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (sums[start + middle] <= p) low = middle;
    else high = middle;
  }
  const [a, b] = [sums[start + low], sums[start + low + 1]];
  return [low, b > a ? Math.min((p - a) / (b - a), 1) : 0.5];
}
