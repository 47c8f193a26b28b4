import { toHalf } from '../../../math/half.ts';
import { linearizationTable } from '../../../scene/materials/sampleTexture.ts';
import type { DomePicture } from '../../../scene/types.ts';
import { srgbByte } from '../../../spectrum/display/srgbBytes.ts';
import type { Panorama } from './prefilteredDome.ts';

/** A mip level: RGBA in the encoding of its picture, rows from the top. */
export interface DomeLevel {
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
  /** 4 numbers per texel. */
  readonly data: Uint8Array | Uint16Array;
}

/**
 * The mip levels of a dome's picture, the picture itself first. A texel of level k is the mean over a patch of the sphere that is as wide as it is high,
 * 2ᵏ π/height: towards the poles over several texels of its row, since these are narrower there by the sine of their angle from the pole. So a round footprint, which
 * aberration leaves round, needs one sample everywhere. Rows count by their solid angle.
 */
export function domeMipmaps(picture: DomePicture): readonly DomeLevel[] {
  const { width, height, data } = picture;
  const levels: DomeLevel[] = [{ width, height, data }];
  const encode = encoderOf(picture);
  let source = rowsOfPicture(picture);
  while (source.width > 1 || source.height > 1) {
    const map = halved(source);
    const texels = new (data instanceof Uint8Array ? Uint8Array : Uint16Array)(4 * map.width * map.height);
    encode(roundFootprints(map), texels);
    levels.push({ width: map.width, height: map.height, data: texels });
    source = rowsOfMap(map);
  }
  return levels;
}

/** Linear light by rows. */
interface Rows {
  readonly width: number;
  readonly height: number;
  /** Adds row y times `weight` to `sums`, 3 numbers per texel. */
  add(y: number, weight: number, sums: Float64Array): void;
}

function rowsOfPicture(picture: DomePicture): Rows {
  const { width, height, data } = picture;
  const linear = Float32Array.from(linearizationTable(picture));
  return {
    width,
    height,
    add(y, weight, sums) {
      for (let from = 4 * y * width, to = 0; to < 3 * width; from += 4, to += 3) {
        sums[to] += weight * linear[data[from]];
        sums[to + 1] += weight * linear[data[from + 1]];
        sums[to + 2] += weight * linear[data[from + 2]];
      }
    },
  };
}

const rowsOfMap = ({ width, height, rgb }: Panorama): Rows => ({
  width,
  height,
  add(y, weight, sums) {
    for (let from = 3 * y * width, to = 0; to < 3 * width; from++, to++) sums[to] += weight * rgb[from];
  },
});

/** Half as many columns and rows, rounded down. */
function halved({ width: columns, height: rows, add }: Rows): Panorama {
  const [width, height] = [Math.max(columns >> 1, 1), Math.max(rows >> 1, 1)];
  const rgb = new Float32Array(3 * width * height);
  const across = coverage(columns, width);
  const down = coverage(rows, height);
  // With the last texel before the first, and the first after the last.
  const sums = new Float64Array(3 * (columns + 2));
  const inside = sums.subarray(3, 3 * (columns + 1));
  for (let y = 0; y < height; y++) {
    sums.fill(0);
    const row = (j: number): number => Math.min(Math.max(down.first[y] + j, 0), rows - 1);
    const areas = Array.from(
      { length: down.count },
      (_, j) => down.weights[y * down.count + j] * Math.sin((Math.PI * (row(j) + 0.5)) / rows),
    );
    const whole = areas.reduce((sum, area) => sum + area, 0);
    areas.forEach((area, j) => {
      if (area > 0) add(row(j), area / whole, inside);
    });
    sums.copyWithin(0, 3 * columns, 3 * (columns + 1));
    sums.copyWithin(3 * (columns + 1), 3, 6);
    sumColumns(sums, across, rgb, 3 * y * width);
  }
  return { width, height, rgb };
}

/**
 * Of each texel, to its neighbours before texels are added. Means of pairs alone show what is one texel wide up to half a pixel from its place; a quarter to each neighbour would
 * show it exactly there, but blurred: noise of all sizes then is 4.5 % off a pixel's mean, with these shares 3 %.
 */
const SHARES = [1 / 12, 10 / 12, 1 / 12] as const;

/** Which texels each texel of a reduced row has parts of, `count` from `first` on, with weights of sum 1; beyond the ends, too. */
interface Coverage {
  readonly count: number;
  readonly first: Int32Array;
  readonly weights: Float64Array;
}

function coverage(from: number, to: number): Coverage {
  const boxes = Math.ceil(from / to);
  const count = boxes + 2;
  const first = Int32Array.from({ length: to }, (_, i) => Math.min(Math.floor((i * from) / to), from - boxes) - 1);
  const weights = new Float64Array(to * count);
  for (let i = 0; i < to; i++)
    for (let k = 0; k < boxes; k++) {
      const texel = first[i] + 1 + k;
      const part = Math.min(((i + 1) * from) / to, texel + 1) - Math.max((i * from) / to, texel);
      SHARES.forEach((share, j) => {
        weights[i * count + k + j] += (share * Math.max(part, 0) * to) / from;
      });
    }
  return { count, first, weights };
}

function sumColumns(sums: Float64Array, { count, first, weights }: Coverage, out: Float32Array, at: number): void {
  for (let x = 0, to = at; x < first.length; x++, to += 3) {
    let [r, g, b] = [0, 0, 0];
    for (let i = 0, from = 3 * (first[x] + 1); i < count; i++, from += 3) {
      const weight = weights[x * count + i];
      r += weight * sums[from];
      g += weight * sums[from + 1];
      b += weight * sums[from + 2];
    }
    out[to] = r;
    out[to + 1] = g;
    out[to + 2] = b;
  }
}

/** Footprints of fewer texels are left as they are: within 30° of the equator of a picture twice as wide as high. */
const LEAST_AVERAGED = 1.155;

/** The map, its rows near the poles averaged over as many texels as are as wide as one is high. */
function roundFootprints({ width, height, rgb }: Panorama): Float32Array {
  const out = new Float32Array(rgb.length);
  for (let y = 0; y < height; y++) {
    const texels = width / (2 * height * Math.sin((Math.PI * (y + 0.5)) / height));
    const [start, end] = [3 * y * width, 3 * (y + 1) * width];
    const row = rgb.subarray(start, end);
    if (texels < LEAST_AVERAGED) out.set(row, start);
    else averageRow(row, out.subarray(start, end), Math.min(texels, width));
  }
  return out;
}

/** Means of RGB over `texels` texels around each one of a row, across its ends. */
function averageRow(row: Float32Array, out: Float32Array, texels: number): void {
  const reach = 3 * Math.ceil(texels / 2);
  // The row goes on beyond its ends.
  const ring = new Float64Array(row.length + 2 * reach);
  ring.set(row.subarray(row.length - reach));
  ring.set(row, reach);
  ring.set(row.subarray(0, reach), reach + row.length);
  const sums = new Float64Array(ring.length + 3);
  for (let i = 0; i < ring.length; i++) sums[i + 3] = sums[i] + ring[i];
  // From each texel's own place, where its mean begins and ends: a whole number of texels, and a part of the next.
  const [begin, end] = [(1 - texels) / 2, (1 + texels) / 2];
  const [first, last] = [reach + 3 * Math.floor(begin), reach + 3 * Math.floor(end)];
  const [before, after] = [begin - Math.floor(begin), end - Math.floor(end)];
  for (let i = 0; i < row.length; i++) {
    const [from, to] = [first + i, last + i];
    const sum = sums[to] - sums[from] + after * (sums[to + 3] - sums[to]) - before * ring[from];
    out[i] = sum / texels;
  }
}

/** Writes linear RGB as texels of the picture's kind, opaque. */
function encoderOf({ data, colorSpace }: DomePicture): (rgb: Float32Array, texels: Uint8Array | Uint16Array) => void {
  if (data instanceof Uint16Array)
    return (rgb, texels) => {
      texels.fill(toHalf(1));
      for (let from = 0, to = 0; from < rgb.length; from += 3, to += 4) {
        texels[to] = toHalf(rgb[from]);
        texels[to + 1] = toHalf(rgb[from + 1]);
        texels[to + 2] = toHalf(rgb[from + 2]);
      }
    };
  const byteOf = colorSpace === 'srgb' ? srgbByte : (value: number) => Math.round(255 * value);
  return (rgb, texels) => {
    texels.fill(255);
    for (let from = 0, to = 0; from < rgb.length; from += 3, to += 4) {
      texels[to] = byteOf(rgb[from]);
      texels[to + 1] = byteOf(rgb[from + 1]);
      texels[to + 2] = byteOf(rgb[from + 2]);
    }
  };
}
