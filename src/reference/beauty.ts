import { toneMap } from '../spectrum/toneMap.ts';
import { cameraRay } from './camera.ts';
import { radiance } from './path.ts';
import { pixelSequence } from './sequence.ts';
import type { Tile, TileRequest } from './tile.ts';
import type { TracedScene } from './trace.ts';

/** Where the means of a tile's samples go, 3 values per pixel; what is absent is not wanted. */
export interface Means {
  readonly beauty?: Float32Array;
  readonly picture?: Float32Array;
}

/**
 * The light of a tile, and what a screen shows of it: means over n × n samples per pixel; a single one is at the pixel's centre, where
 * the data are taken. A sample is tone mapped before it is averaged, as the rasterizer does, so that edges of very bright things are
 * smooth too. The sequence is the pixel's own, so that every division into tiles gives the same bits.
 */
export function fillBeauty(scene: TracedScene, request: TileRequest, { x0, y0, x1, y1 }: Tile, means: Means): void {
  const { view, settings, width, height, samples: n, seed, light } = request;
  for (let y = y0; y < y1; y++)
    for (let x = x0; x < x1; x++) {
      const numbers = pixelSequence(seed, x, y);
      const sums = [0, 0, 0, 0, 0, 0];
      for (let i = 0; i < n * n; i++) {
        const random = numbers(i);
        const [right, down] = n === 1 ? [0.5, 0.5] : [random(), random()];
        const ray = cameraRay(view, settings, x + right, y + down, width, height);
        const arrived = radiance(scene, ray, view, settings, light, random);
        const shown = toneMap(arrived, settings.exposure);
        for (let k = 0; k < 3; k++) {
          sums[k] += arrived[k] / (n * n);
          sums[3 + k] += shown[k] / (n * n);
        }
      }
      const pixel = 3 * ((y - y0) * (x1 - x0) + (x - x0));
      means.beauty?.set(sums.slice(0, 3), pixel);
      means.picture?.set(sums.slice(3), pixel);
    }
}
