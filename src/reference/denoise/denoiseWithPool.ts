import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { LUMINANCE_WEIGHTS } from '../../spectrum/color/observerColor.ts';
import type { ImageTile } from '../tileRequest.ts';
import { copyTile, type TracerPool } from '../tracerPool.ts';
import type { NoisyTile } from './noisyTile.ts';

/** Side of the tiles, which belong to the picture, so that no bit depends on threads; a window takes some 150 MB [px]. */
const TILE = 384;
/** What the network sees around a tile: its pixels depend on those up to 87 away [px]. */
const MARGIN = 96;

/** Layers of a whole picture: 3 values per pixel, rows from the top. */
export interface NoisyPicture extends Readonly<Record<'beauty' | 'albedo' | 'normal', Float32Array>> {
  /** The sky has stars, which would be taken for noise: pixels where no surface is near stay as they are. */
  readonly hasStars: boolean;
}

/** The beauty without its noise, by the threads of a pool. `onProgress` receives the finished fraction, 0 … 1. */
export async function denoiseWithPool(
  pool: TracerPool,
  picture: NoisyPicture,
  { width, height }: PictureSize,
  onProgress: (fraction: number) => void = () => {},
): Promise<Float32Array<ArrayBuffer>> {
  const gain = gainOf(picture.beauty, width, height);
  const clean = new Float32Array(3 * width * height);
  const orders: { tile: ImageTile; noisy: NoisyTile }[] = [];
  for (let y0 = 0; y0 < height; y0 += TILE)
    for (let x0 = 0; x0 < width; x0 += TILE) {
      const tile = { x0, y0, x1: Math.min(x0 + TILE, width), y1: Math.min(y0 + TILE, height) };
      const window = {
        x0: Math.max(x0 - MARGIN, 0),
        y0: Math.max(y0 - MARGIN, 0),
        x1: Math.min(tile.x1 + MARGIN, width),
        y1: Math.min(tile.y1 + MARGIN, height),
      };
      const part = (values: Float32Array): Float32Array => partOf(values, width, window);
      const { beauty, albedo, normal } = picture;
      orders.push({
        tile,
        noisy: { window, beauty: part(beauty), albedo: part(albedo), normal: part(normal), gain },
      });
    }
  let done = 0;
  await pool.denoise(orders, (tile, { beauty }) => {
    copyTile(clean, width, tile, beauty);
    onProgress(++done / orders.length);
  });
  if (picture.hasStars) keepSky(clean, picture, width, height);
  return clean;
}

function keepSky(clean: Float32Array, { beauty, normal }: NoisyPicture, width: number, height: number): void {
  const isSurface = (x: number, y: number): boolean => {
    const i = 3 * (y * width + x);
    return x >= 0 && x < width && y >= 0 && y < height && Math.hypot(normal[i]!, normal[i + 1]!, normal[i + 2]!) > 0;
  };
  const near = [-1, 0, 1];
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      if (near.some((dy) => near.some((dx) => isSurface(x + dx, y + dy)))) continue;
      const i = 3 * (y * width + x);
      clean.set(beauty.subarray(i, i + 3), i);
    }
}

function partOf(values: Float32Array, width: number, { x0, y0, x1, y1 }: ImageTile): Float32Array {
  const part = new Float32Array(3 * (x1 - x0) * (y1 - y0));
  for (let y = y0; y < y1; y++)
    part.set(values.subarray(3 * (y * width + x0), 3 * (y * width + x1)), 3 * (y - y0) * (x1 - x0));
  return part;
}

/** Side of the cells whose logarithms are averaged [px], the darkest one that counts, and the luminance that the mean gets. */
const [CELL, DARKEST, KEY] = [16, 1e-8, 0.18];

/** The exposure that the network was trained with. Source: devices/cpu/cpu_autoexposure.cpp of Open Image Denoise 2. */
function gainOf(beauty: Float32Array, width: number, height: number): number {
  let [sum, count] = [0, 0];
  for (let top = 0; top < height; top += CELL)
    for (let left = 0; left < width; left += CELL) {
      const luminance = meanLuminance(beauty, width, {
        x0: left,
        y0: top,
        x1: Math.min(left + CELL, width),
        y1: Math.min(top + CELL, height),
      });
      if (!(luminance > DARKEST)) continue;
      sum += Math.log2(luminance);
      count++;
    }
  return count > 0 ? KEY / 2 ** (sum / count) : 1;
}

function meanLuminance(beauty: Float32Array, width: number, { x0, y0, x1, y1 }: ImageTile): number {
  let sum = 0;
  for (let y = y0; y < y1; y++)
    for (let x = x0; x < x1; x++)
      LUMINANCE_WEIGHTS.forEach((weight, k) => {
        sum += weight * beauty[3 * (y * width + x) + k]!;
      });
  return sum / ((x1 - x0) * (y1 - y0));
}
