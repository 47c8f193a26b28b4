import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { LUMINANCE_WEIGHTS } from '../../spectrum/color/observerColor.ts';
import { squaresOfPicture } from '../squares.ts';
import { channelsOf } from '../tile.ts';
import type { ImageTile } from '../tileRequest.ts';
import { copyTile, type TracerPool } from '../tracerPool.ts';

/** Side of the tiles, which belong to the picture, so that no bit depends on threads; a window takes some 150 MB [px]. */
const TILE = 384;
/** What the network sees around a tile: its pixels depend on those up to 87 away [px]. */
const MARGIN = 96;

export interface NoisyPicture {
  /** The layer `denoiser_input` of a whole picture. */
  readonly values: Float32Array;
  /** The sky has stars, which would be taken for noise: pixels where no surface is near stay as they are. */
  readonly hasStars: boolean;
}

const CHANNELS = channelsOf('denoiser_input');

/** The light without its noise, linear radiance, 3 values per pixel, by the threads of a pool. `onProgress` receives the finished fraction, 0 … 1. */
export async function denoiseWithPool(
  pool: TracerPool,
  picture: NoisyPicture,
  { width, height }: PictureSize,
  onProgress: (fraction: number) => void = () => {},
): Promise<Float32Array<ArrayBuffer>> {
  const gain = gainOf(picture.values, width, height);
  const clean = new Float32Array(3 * width * height);
  const orders = squaresOfPicture({ width, height }, TILE).map((tile) => {
    const window = {
      x0: Math.max(tile.x0 - MARGIN, 0),
      y0: Math.max(tile.y0 - MARGIN, 0),
      x1: Math.min(tile.x1 + MARGIN, width),
      y1: Math.min(tile.y1 + MARGIN, height),
    };
    return { tile, noisy: { window, values: partOf(picture.values, width, window), gain } };
  });
  let done = 0;
  await pool.denoise(orders, (tile, { beauty }) => {
    copyTile(clean, width, tile, beauty);
    onProgress(++done / orders.length);
  });
  if (picture.hasStars) keepSky(clean, picture, width, height);
  return clean;
}

function keepSky(clean: Float32Array, { values }: NoisyPicture, width: number, height: number): void {
  const isSurface = (x: number, y: number): boolean => {
    const i = CHANNELS * (y * width + x);
    const [nx, ny, nz] = values.subarray(i + 6, i + 9);
    return x >= 0 && x < width && y >= 0 && y < height && Math.hypot(nx!, ny!, nz!) > 0;
  };
  const near = [-1, 0, 1];
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      if (near.some((dy) => near.some((dx) => isSurface(x + dx, y + dy)))) continue;
      const i = y * width + x;
      clean.set(values.subarray(CHANNELS * i, CHANNELS * i + 3), 3 * i);
    }
}

function partOf(values: Float32Array, width: number, { x0, y0, x1, y1 }: ImageTile): Float32Array {
  const part = new Float32Array(CHANNELS * (x1 - x0) * (y1 - y0));
  for (let y = y0; y < y1; y++) {
    const row = values.subarray(CHANNELS * (y * width + x0), CHANNELS * (y * width + x1));
    part.set(row, CHANNELS * (y - y0) * (x1 - x0));
  }
  return part;
}

/** Side of the cells whose logarithms are averaged [px], the darkest one that counts, and the luminance that the mean gets. */
const [CELL, DARKEST, KEY] = [16, 1e-8, 0.18];

/** The exposure that the network was trained with. Source: devices/cpu/cpu_autoexposure.cpp of Open Image Denoise 2. */
function gainOf(values: Float32Array, width: number, height: number): number {
  let [sum, count] = [0, 0];
  for (const cell of squaresOfPicture({ width, height }, CELL)) {
    const luminance = meanLuminance(values, width, cell);
    if (!(luminance > DARKEST)) continue;
    sum += Math.log2(luminance);
    count++;
  }
  return count > 0 ? KEY / 2 ** (sum / count) : 1;
}

function meanLuminance(values: Float32Array, width: number, { x0, y0, x1, y1 }: ImageTile): number {
  let sum = 0;
  for (let y = y0; y < y1; y++)
    for (let x = x0; x < x1; x++)
      LUMINANCE_WEIGHTS.forEach((weight, k) => {
        sum += weight * values[CHANNELS * (y * width + x) + k]!;
      });
  return sum / ((x1 - x0) * (y1 - y0));
}
