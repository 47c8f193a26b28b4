import { directionFromLatLong } from '../../../scene/lights/latLong.ts';
import type { DomeLight } from '../../../scene/types.ts';
import type { PictureSize } from '../../../scene/view/pictureSize.ts';
import type { HalfTexels } from '../../../shaders/tables/halfAtlas.ts';
import { BORDER, writeBordered } from './borderedMap.ts';
import { type Panorama, PREFILTER_SIZE, reducedDome, resize } from './prefilteredDome.ts';
import { coneCosine, MEAN_RAPIDITIES } from './skyMeans.ts';

/** Size of the panoramas of means, by axis. */
export const MEAN_SIZE = { width: 64, height: 32 } as const;
/** Panoramas for each rapidity: L, then L n by the dome's own axes, and L over all of the cone alike. */
const MOMENTS = 4;
const PANORAMAS = MOMENTS + 1;
/** Cosine from which on means over a cone need fewer pixels and axes: of 60° and more. */
const WIDE_CONE = 0.5;

/** The means of a dome's picture, taken of `source` pixels of it: those of a rapidity side by side, each with a wrapped border of one pixel, one rapidity below the other. */
export function pictureMeans(
  picture: NonNullable<DomeLight['texture']>,
  source: PictureSize = PREFILTER_SIZE,
): HalfTexels {
  const fine = withMoments(reducedDome(picture, source));
  const coarse = withMoments(reducedDome(picture, { width: source.width / 2, height: source.height / 2 }));
  const [columns, rows] = [MEAN_SIZE.width + 2 * BORDER, MEAN_SIZE.height + 2 * BORDER];
  const width = PANORAMAS * columns;
  const texels = { data: new Uint16Array(4 * width * rows * MEAN_RAPIDITIES.count), width };
  for (let level = 0; level < MEAN_RAPIDITIES.count; level++) {
    const c = coneCosine(level);
    const [map, most] = c > WIDE_CONE ? [fine, MEAN_SIZE.width] : [coarse, MEAN_SIZE.width / 2];
    coneMeans(map, Math.min(map.width, most), c).forEach((means, k) => {
      writeBordered(resize(means, MEAN_SIZE), texels, k * columns, level * rows);
    });
  }
  return texels;
}

/** Numbers per pixel of L and L n. */
const CHANNELS = 3 * MOMENTS;

interface MomentMap {
  readonly width: number;
  readonly height: number;
  readonly values: Float32Array;
}

function withMoments({ width, height, rgb }: Panorama): MomentMap {
  const values = new Float32Array(CHANNELS * width * height);
  for (let i = 0; i < width * height; i++) {
    const n = directionFromLatLong(((i % width) + 0.5) / width, 1 - (Math.floor(i / width) + 0.5) / height);
    [1, ...n].forEach((factor, k) => {
      for (let channel = 0; channel < 3; channel++)
        values[CHANNELS * i + 3 * k + channel] = factor * rgb[3 * i + channel];
    });
  }
  return { width, height, values };
}

/** The means for the axes of a coarser map: so a bright spot keeps its place. */
function coneMeans({ width, height, values }: MomentMap, columns: number, c: number): readonly Panorama[] {
  const stride = width / columns;
  const rows = height / stride;
  const maps = Array.from({ length: PANORAMAS }, () => new Float32Array(3 * columns * rows));
  const sums = new Float64Array(rows);
  const evenSums = new Float64Array(rows);
  const weights = new Float64Array(width);
  // Two copies, so that neighbours beyond the seam are contiguous.
  const ring = new Float32Array(2 * CHANNELS * width);
  const mean = new Float64Array(CHANNELS);
  const even = new Float64Array(3);
  // Columns count from this one, relative to the left edge of the axis' own.
  const first = (stride - width) / 2;
  for (let v = 0; v < height; v++) {
    const source = values.subarray(CHANNELS * v * width, CHANNELS * (v + 1) * width);
    ring.set(source);
    ring.set(source, CHANNELS * width);
    const [cv, sv] = [Math.cos((Math.PI * (v + 0.5)) / height), Math.sin((Math.PI * (v + 0.5)) / height)];
    for (let y = 0; y < rows; y++) {
      const [cy, sy] = [Math.cos((Math.PI * (y + 0.5)) / rows), Math.sin((Math.PI * (y + 0.5)) / rows)];
      let [from, to] = [width, 0];
      for (let d = 0; d < width; d++) {
        const apart = (2 * Math.PI * (first + d + 0.5 - stride / 2)) / width;
        weights[d] = sv * Math.max(cy * cv + sy * sv * Math.cos(apart) - c, 0);
        sums[y] += weights[d];
        if (weights[d] > 0) [from, to] = [Math.min(from, d), d + 1];
      }
      evenSums[y] += sv * Math.max(to - from, 0);
      for (let x = 0; x < columns && from < to; x++) {
        mean.fill(0);
        even.fill(0);
        const start = (x * stride + first + from + 2 * width) % width;
        for (let d = from, i = CHANNELS * start; d < to; d++)
          for (let k = 0; k < CHANNELS; k++, i++) {
            mean[k] += weights[d] * ring[i];
            if (k < 3) even[k] += sv * ring[i];
          }
        for (let k = 0; k < CHANNELS; k++) maps[Math.floor(k / 3)][3 * (y * columns + x) + (k % 3)] += mean[k];
        for (let k = 0; k < 3; k++) maps[MOMENTS][3 * (y * columns + x) + k] += even[k];
      }
    }
  }
  return maps.map((rgb, k) => ({
    width: columns,
    height: rows,
    rgb: rgb.map((value, i) => value / (k < MOMENTS ? sums : evenSums)[Math.floor(i / (3 * columns))]),
  }));
}
