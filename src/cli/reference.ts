import { availableParallelism } from 'node:os';
import { toScreen } from '../reference/display.ts';
import { DEFAULT_LIGHT, type LightOptions } from '../reference/lighting.ts';
import { channelsOf, type Tile, type TileRequest } from '../reference/tile.ts';
import type { Scene } from '../scene/types.ts';
import type { AovName } from '../scene/view.ts';
import { CliError, EXIT } from './exit.ts';
import { speedOfLight } from './flags.ts';
import { stopWithUs } from './output.ts';
import type { Painter, Picture } from './painter.ts';
import type { Size } from './parse.ts';
import type { RenderFlags } from './render.ts';
import { TracerPool } from './tracerPool.ts';

/** Small enough that the threads end together, large enough that telling of them costs nothing [px]. */
const TILE = 16;

/** Draws on the processor: 64-bit arithmetic, no GPU. */
export async function openReferencePainter(scene: Scene, flags: RenderFlags): Promise<Painter> {
  const { size, seed = 0 } = flags;
  const light = lightOptions(flags);
  const tiles = tilesOf(size);
  const threads = Math.min(flags.threads ?? availableParallelism(), tiles.length);
  const pool = new TracerPool(scene, speedOfLight(scene, flags.c), { threads });
  const forget = stopWithUs({ kill: () => pool.stop(new CliError(EXIT.cancelled, 'stopped')) });
  return {
    info: { pipeline: 'reference', threads, seed },
    usualSamples: 4,
    paint: ({ view, settings, samples, pixels, aovs }, onPart) => {
      const layers = pixels ? [...aovs, 'picture' as const] : aovs;
      return paint(pool, tiles, { view, settings, ...size, layers, samples, seed, light }, onPart);
    },
    close: async () => {
      forget();
      await pool.close();
    },
  };
}

const lightOptions = ({ bounces = DEFAULT_LIGHT.bounces, mirrors, glass }: RenderFlags): LightOptions => ({
  bounces,
  mirrors,
  glass,
});

/** A picture in tiles, row by row. */
export function tilesOf({ width, height }: Size): Tile[] {
  const tiles: Tile[] = [];
  for (let y0 = 0; y0 < height; y0 += TILE) {
    for (let x0 = 0; x0 < width; x0 += TILE) {
      tiles.push({ x0, y0, x1: Math.min(x0 + TILE, width), y1: Math.min(y0 + TILE, height) });
    }
  }
  return tiles;
}

async function paint(
  pool: TracerPool,
  tiles: readonly Tile[],
  request: TileRequest,
  onPart: (part: number) => void = () => {},
): Promise<Picture> {
  const { width, height, layers } = request;
  const images = new Map(layers.map((layer) => [layer, new Float32Array(width * height * channelsOf(layer))]));
  let done = 0;
  await pool.draw(request, tiles, (tile, data) => {
    for (const [layer, image] of images) place(image, width, tile, data[layer]);
    done++;
    onPart(done / tiles.length);
  });
  const picture = images.get('picture');
  const pixels = picture ? toScreen(picture, width, height) : new Uint8Array();
  const aovs = new Map<AovName, Float32Array>();
  for (const [layer, image] of images) if (layer !== 'picture') aovs.set(layer, image);
  return { pixels, aovs };
}

/** Puts the rows of a tile where they belong. */
function place(image: Float32Array, width: number, { x0, y0, x1, y1 }: Tile, part: Float32Array | undefined): void {
  if (!part) return;
  const values = part.length / ((x1 - x0) * (y1 - y0));
  const row = values * (x1 - x0);
  for (let y = y0; y < y1; y++) {
    image.set(part.subarray((y - y0) * row, (y - y0 + 1) * row), values * (y * width + x0));
  }
}
