import type { ImageTile } from '../tileRequest.ts';
import { emptyChannel } from './convolution.ts';
import type { NoisyTile } from './noisyTile.ts';
import { decodeLight, encodeLight } from './transfer.ts';
import { parseTza, type Tensor } from './tza.ts';
import { runUnet, UNET_ALIGNMENT } from './unet.ts';
import { WEIGHTS } from './weights.ts';

let weights: ReadonlyMap<string, Tensor> | undefined;

/** The linear radiance of a tile without its noise, 3 values per pixel. */
export function denoiseTile(tile: ImageTile, { window, values, gain }: NoisyTile): Float32Array {
  weights ??= parseTza(Uint8Array.from(atob(WEIGHTS), (character) => character.charCodeAt(0)));
  const [columns, rows] = [window.x1 - window.x0, window.y1 - window.y0];
  const [width, height] = [aligned(columns), aligned(rows)];
  const channel = (k: number, encode: (value: number) => number): Float32Array => {
    const out = emptyChannel(width, height);
    for (let y = 0; y < rows; y++)
      for (let x = 0; x < columns; x++) out[(y + 1) * (width + 2) + x + 1] = encode(values[9 * (y * columns + x) + k]!);
    return out;
  };
  const channels = [
    ...[0, 1, 2].map((k) => channel(k, (value) => encodeLight(value * gain))),
    ...[3, 4, 5].map((k) => channel(k, (value) => Math.min(Math.max(value, 0), 1))),
    ...[6, 7, 8].map((k) => channel(k, (value) => (1 + value) / 2)),
  ];
  const clean = runUnet(weights, { width, height, channels }).channels;
  const [tileWidth, tileHeight] = [tile.x1 - tile.x0, tile.y1 - tile.y0];
  const out = new Float32Array(3 * tileWidth * tileHeight);
  for (let y = 0; y < tileHeight; y++)
    for (let x = 0; x < tileWidth; x++) {
      const at = (y + tile.y0 - window.y0 + 1) * (width + 2) + x + tile.x0 - window.x0 + 1;
      for (let k = 0; k < 3; k++) out[3 * (y * tileWidth + x) + k] = decodeLight(clean[k]![at]!) / gain;
    }
  return out;
}

const aligned = (size: number): number => UNET_ALIGNMENT * Math.ceil(size / UNET_ALIGNMENT);
