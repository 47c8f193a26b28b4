import type { Random } from '../../../math/random.ts';
import { dot, type Vec3 } from '../../../math/vec3.ts';
import { directionFromLatLong, domeAxes, latLongFromDirection } from '../../../scene/lights/latLong.ts';
import { linearizationTable } from '../../../scene/materials/sampleTexture.ts';
import type { DomeLight } from '../../../scene/types.ts';
import { LUMINANCE_WEIGHTS } from '../../../spectrum/color/observerColor.ts';

/** Where the light of a sky is brighter than its mean: directions are asked there more often than where a surface would look for light by itself. */
export interface SkySampler {
  /** Of all directions that are asked, so many are chosen here, 0 … ½. */
  readonly probability: number;
  /** One of them: unit, world. */
  sample(random: Random): Vec3;
  /** How densely they lie about the unit direction n of the world [1/sr]. */
  pdf(n: Vec3): number;
}

/** So many columns at most: of larger pictures, means over blocks are its texels. */
const MAX_COLUMNS = 2048;
/** What a surface finds by itself stays at least so much of what is asked. */
const MAX_PROBABILITY = 0.5;

/**
 * The bright parts of a dome's picture; undefined where it has none. A texel's share is max(luminance − mean, 0) times its solid angle, for what is below the mean a
 * surface finds by itself (Karlík et al. 2019, "MIS compensation", ACM TOG 38(6)). A row, and a texel of it, are found in sums that rise, and a place
 * about the texel by a tent: the density is linear between texels, as what is seen of them is.
 */
export function skySampler(dome: DomeLight): SkySampler | undefined {
  const texels = texelsOf(dome);
  if (!texels) return undefined;
  const { width, height, excess, share } = texels;
  const [x, y, z] = domeAxes(dome);
  const rows = rowCdfs(excess, width, height);
  const marginal = cdfOf(rows.sums);
  const chanceOf = (column: number, row: number): number => {
    const j = Math.min(Math.max(row, 0), height - 1);
    const at = j * (width + 1) + ((column + width) % width);
    return (marginal[j + 1] - marginal[j]) * (rows.rising[at + 1] - rows.rising[at]);
  };
  return {
    probability: Math.min(share, MAX_PROBABILITY),
    sample: (random) => {
      const [row, down] = invertCdf(marginal, 0, height, random());
      const [column, right] = invertCdf(rows.rising, row * (width + 1), width, random());
      // Beyond a pole the picture is its last row still.
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
      const across = (row: number): number => (1 - s) * chanceOf(left, row) + s * chanceOf(left + 1, row);
      const chance = (1 - t) * across(top) + t * across(top + 1);
      return (chance * width * height) / (2 * Math.PI ** 2 * Math.sqrt(Math.max(1 - up * up, 1e-12)));
    },
  };
}

/** A number of −1 … 1 with the density 1 − |x|, rising with p. */
const tentOffset = (p: number): number => (p < 0.5 ? Math.sqrt(2 * p) - 1 : 1 - Math.sqrt(2 - 2 * p));

interface TexelExcess {
  readonly width: number;
  readonly height: number;
  /** Power of each above the mean. */
  readonly excess: Float32Array;
  /** All of it, over all of the power. */
  readonly share: number;
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
  // All rows together are 2 high, each `width` wide.
  const mean = total / (2 * width);
  const excess = values.map((value, i) => Math.max(value - mean, 0) * sizes[Math.floor(i / width)]);
  const above = excess.reduce((sum, part) => sum + part, 0);
  const share = above / total;
  // What rounding makes of an even sky is no bright part.
  return share > 1e-3 ? { width, height, excess, share } : undefined;
}

interface LuminanceMap {
  readonly width: number;
  readonly height: number;
  readonly values: Float32Array;
}

function luminances({ texture, color }: DomeLight): LuminanceMap | undefined {
  if (!texture) return undefined;
  const block = Math.ceil(texture.width / MAX_COLUMNS);
  const [width, height] = [Math.ceil(texture.width / block), Math.ceil(texture.height / block)];
  const [r, g, b] = LUMINANCE_WEIGHTS.map((part, k) => part * color[k]);
  const linear = linearizationTable(texture);
  const values = new Float32Array(width * height);
  const { data } = texture;
  for (let y = 0, i = 0; y < texture.height; y++)
    for (let x = 0; x < texture.width; x++, i += 4)
      values[Math.floor((y * height) / texture.height) * width + Math.floor((x * width) / texture.width)] +=
        (r * linear[data[i]] + g * linear[data[i + 1]] + b * linear[data[i + 2]]) / (block * block);
  return { width, height, values };
}

/** Of each row the sums up to each column, from 0 to 1; and of all rows the sums. */
function rowCdfs(values: Float32Array, width: number, height: number) {
  const all = new Float32Array((width + 1) * height);
  const sums = Float32Array.from({ length: height }, (_, row) => {
    const own = values.subarray(row * width, (row + 1) * width);
    all.set(cdfOf(own), row * (width + 1));
    return own.reduce((sum, value) => sum + value, 0);
  });
  return { rising: all, sums };
}

/** From 0 to 1, one more than there are values; all 0 where they are. */
function cdfOf(values: Float32Array): Float32Array {
  const out = new Float32Array(values.length + 1);
  let sum = 0;
  const whole = values.reduce((total, value) => total + value, 0) || 1;
  values.forEach((value, i) => {
    sum += value;
    out[i + 1] = sum / whole;
  });
  return out;
}

/** The step of rising sums, from `start` on, in which p lies, and where in it, 0 … 1. */
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
