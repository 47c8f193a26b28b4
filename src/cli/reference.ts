import { availableParallelism } from 'node:os';
import { displayed, toScreen } from '../reference/display.ts';
import type { Tile, TileRequest } from '../reference/tile.ts';
import type { Scene } from '../scene/types.ts';
import { AOVS, type AovName } from '../scene/view.ts';
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
  const tiles = cut(size);
  const threads = Math.min(flags.threads ?? availableParallelism(), tiles.length);
  const pool = new TracerPool(scene, speedOfLight(scene, flags.c), { threads });
  const forget = stopWithUs({ kill: () => pool.stop(new CliError(EXIT.cancelled, 'stopped')) });
  return {
    info: { pipeline: 'reference', threads, seed },
    usualSamples: 4,
    paint: (request, onPart) => paint(pool, tiles, { ...request, ...size, seed }, request.pixels, onPart),
    close: async () => {
      forget();
      await pool.close();
    },
  };
}

function cut({ width, height }: Size): Tile[] {
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
  wanted: boolean,
  onPart: (part: number) => void = () => {},
): Promise<Picture> {
  const { width, height } = request;
  const names: readonly AovName[] = wanted ? [...request.aovs, 'beauty'] : request.aovs;
  const whole = new Map(names.map((name) => [name, new Float32Array(width * height * AOVS[name].channels.length)]));
  let done = 0;
  await pool.draw({ ...request, aovs: names }, tiles, (tile, data) => {
    for (const [name, image] of whole) place(image, width, tile, data[name]);
    done++;
    onPart(done / tiles.length);
  });
  const light = whole.get('beauty');
  const pixels = wanted && light ? toScreen(displayed(light, request.settings), width, height) : new Uint8Array();
  return { pixels, aovs: whole };
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
