import { availableParallelism } from 'node:os';
import type { Vec3 } from '../math/vec3.ts';
import { toScreen } from '../reference/display.ts';
import { DEFAULT_LIGHT, type LightOptions } from '../reference/lighting.ts';
import { aovsOf, composed, type TakenPicture } from '../reference/plan.ts';
import { channelsOf, type Layer, type Tile, type TileRequest } from '../reference/tile.ts';
import { upOf } from '../scene/daylight.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view.ts';
import { toneMap } from '../spectrum/toneMap.ts';
import { CliError, EXIT, usageError } from './exit.ts';
import { speedOfLight } from './flags.ts';
import { stopWithUs } from './output.ts';
import type { Painter, Picture, Scenes } from './painter.ts';
import type { Size } from './parse.ts';
import type { RenderFlags } from './render.ts';
import { TracerPool } from './tracerPool.ts';

/** Small enough that the threads end together, large enough that telling of them costs nothing [px]. */
const TILE = 16;

/** Draws on the processor: 64-bit arithmetic, no GPU. */
export async function openReferencePainter(scenes: Scenes, flags: RenderFlags): Promise<Painter> {
  const { size, seed = 0 } = flags;
  const light = lightOptions(flags);
  const tiles = tilesOf(size);
  const threads = Math.min(flags.threads ?? availableParallelism(), tiles.length);
  const pools = new Pools(scenes, threads);
  // Threads take a while to begin.
  pools.of(0, speedOfLight(scenes[0], flags.c));
  const forget = stopWithUs({ kill: () => pools.stop(new CliError(EXIT.cancelled, 'stopped')) });
  return {
    info: { pipeline: 'reference', threads, seed },
    usualSamples: 4,
    paint: ({ view, settings, samples, pixels, aovs }, onPart) => {
      const request = { view, ...size, samples, seed, light };
      const draw = (scene: number, own: RenderSettings, layers: readonly Layer[], told?: (part: number) => void) =>
        draft(pools.of(scene, own.speedOfLight), tiles, { ...request, settings: own, layers }, told);
      return settings.plan
        ? paintPlan(settings, { view, ...size, scenes, pixels, aovs, draw }, onPart)
        : paint(settings, { ...size, pixels, aovs, draw }, onPart);
    },
    close: async () => {
      forget();
      await pools.close();
    },
  };
}

/** Threads for each scene that is drawn, with each speed of light. */
class Pools {
  private readonly scenes: Scenes;
  private readonly threads: number;
  private readonly open = new Map<string, TracerPool>();

  constructor(scenes: Scenes, threads: number) {
    this.scenes = scenes;
    this.threads = threads;
  }

  of(scene: number, c: number): TracerPool {
    const key = `${scene} ${c}`;
    const pool =
      this.open.get(key) ?? new TracerPool(this.scenes[scene] ?? this.scenes[0], c, { threads: this.threads });
    this.open.set(key, pool);
    return pool;
  }

  stop(error: Error): void {
    for (const pool of this.open.values()) pool.stop(error);
  }

  async close(): Promise<void> {
    await Promise.all([...this.open.values()].map((pool) => pool.close()));
  }
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

/** Draws layers of one G-buffer's picture. */
type Draw = (
  scene: number,
  settings: RenderSettings,
  layers: readonly Layer[],
  onPart?: (part: number) => void,
) => Promise<Map<Layer, Float32Array>>;

interface Wanted extends Size {
  readonly pixels: boolean;
  readonly aovs: readonly AovName[];
  readonly draw: Draw;
}

async function paint(
  settings: RenderSettings,
  { width, height, pixels, aovs, draw }: Wanted,
  onPart?: (part: number) => void,
): Promise<Picture> {
  const images = await draw(0, settings, pixels ? [...aovs, 'picture'] : aovs, onPart);
  const picture = images.get('picture');
  return { pixels: picture ? toScreen(picture, width, height) : new Uint8Array(), aovs: dataOf(images, aovs) };
}

/** Light is the mean of its samples, and data are of the pixels' centres; effects are applied to that, and the tone curve at the end. */
async function paintPlan(
  settings: RenderSettings,
  { width, height, pixels, aovs, draw, view, scenes }: Wanted & { readonly view: ViewPoint; readonly scenes: Scenes },
  onPart: (part: number) => void = () => {},
): Promise<Picture> {
  const { plan, ...first } = settings;
  if (!plan) throw new Error('there is no plan to carry out');
  if (settings.grid)
    throw usageError(
      'the grid is drawn by the rasterizer only, where a project puts its picture together: switch it off',
    );
  const needed = aovsOf(plan).map((names, i) => (i === 0 ? [...new Set([...names, ...aovs])] : names));
  const taken: TakenPicture['buffers'][number][] = [];
  for (const [i, names] of needed.entries()) {
    const own = i === 0 ? first : { ...first, ...plan.others[i - 1] };
    const scene = plan.others[i - 1]?.scene ?? 0;
    const images = await draw(scene, own, names, (part) => onPart((i + part) / needed.length));
    taken.push({ aovs: dataOf(images, names), zenith: upOf((scenes[scene] ?? scenes[0]).upAxis) });
  }
  const light = composed({ view, settings, width, height, buffers: taken });
  const data = new Map(aovs.map((name) => [name, taken[0]!.aovs.get(name)!]));
  if (data.has('beauty')) data.set('beauty', Float32Array.from(light.values));
  if (!pixels) return { pixels: new Uint8Array(), aovs: data };
  const shown = light.map((x, y) => toneMap(light.at(x, y) as unknown as Vec3, settings.exposure, settings.tone));
  return { pixels: toScreen(Float32Array.from(shown.values), width, height), aovs: data };
}

const dataOf = (images: ReadonlyMap<Layer, Float32Array>, names: readonly AovName[]): Map<AovName, Float32Array> =>
  new Map(names.map((name) => [name, images.get(name)!]));

async function draft(
  pool: TracerPool,
  tiles: readonly Tile[],
  request: TileRequest,
  onPart: (part: number) => void = () => {},
): Promise<Map<Layer, Float32Array>> {
  const { width, height, layers } = request;
  const images = new Map(layers.map((layer) => [layer, new Float32Array(width * height * channelsOf(layer))]));
  let done = 0;
  await pool.draw(request, tiles, (tile, data) => {
    for (const [layer, image] of images) place(image, width, tile, data[layer]);
    done++;
    onPart(done / tiles.length);
  });
  return images;
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
