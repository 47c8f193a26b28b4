import { availableParallelism } from 'node:os';
import type { Vec3 } from '../math/vec3.ts';
import type { Painted, Size } from '../nodes/drawing/painter.ts';
import { toScreen } from '../reference/display.ts';
import { DEFAULT_LIGHT, type LightOptions } from '../reference/lightOptions.ts';
import { aovsOf, composed, type TakenPicture } from '../reference/plan.ts';
import { drawnBy, type TracerPool, tilesOf } from '../reference/pool.ts';
import type { Layer } from '../reference/tile.ts';
import { upOf } from '../scene/daylight.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view.ts';
import { toneMap } from '../spectrum/toneMap.ts';
import { CliError, EXIT, usageError } from './exit.ts';
import { speedOfLight } from './flags.ts';
import { stopWithUs } from './output.ts';
import type { Painter, Scenes } from './painter.ts';
import type { RenderFlags } from './render.ts';
import { tracerPool } from './tracerPool.ts';

/** Draws on the processor: 64-bit arithmetic, no GPU. */
export async function openReferencePainter(scenes: Scenes, flags: RenderFlags): Promise<Painter> {
  const { size, seed = 0 } = flags;
  const light = lightOptions(flags);
  const threads = Math.min(flags.threads ?? availableParallelism(), tilesOf(size).length);
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
        drawnBy(pools.of(scene, own.speedOfLight), { ...request, settings: own, layers }, told);
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
    const pool = this.open.get(key) ?? tracerPool(this.scenes[scene] ?? this.scenes[0], c, { threads: this.threads });
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
): Promise<Painted> {
  const images = await draw(0, settings, pixels ? [...aovs, 'picture'] : aovs, onPart);
  const picture = images.get('picture');
  return { pixels: picture ? toScreen(picture, width, height) : new Uint8Array(), aovs: dataOf(images, aovs) };
}

/** Light is the mean of its samples, and data are of the pixels' centres; effects are applied to that, and the tone curve at the end. */
async function paintPlan(
  settings: RenderSettings,
  { width, height, pixels, aovs, draw, view, scenes }: Wanted & { readonly view: ViewPoint; readonly scenes: Scenes },
  onPart: (part: number) => void = () => {},
): Promise<Painted> {
  const { plan, ...first } = settings;
  if (!plan) throw new Error('there is no plan to carry out');
  if (settings.grid)
    throw usageError(
      'the grid is drawn by the rasterizer only, where a project puts its picture together: switch it off',
    );
  // The beauty is what the plan makes.
  const data = aovs.filter((name) => name !== 'beauty');
  const needed = aovsOf(plan).map((names, i) => (i === 0 ? [...new Set([...names, ...data])] : names));
  const taken: TakenPicture['buffers'][number][] = [];
  for (const [i, names] of needed.entries()) {
    const own = i === 0 ? first : { ...first, ...plan.others[i - 1] };
    const scene = plan.others[i - 1]?.scene ?? 0;
    const images = await draw(scene, own, names, (part) => onPart((i + part) / needed.length));
    taken.push({ aovs: dataOf(images, names), zenith: upOf((scenes[scene] ?? scenes[0]).upAxis) });
  }
  const light = composed({ view, settings, width, height, buffers: taken });
  const beauty = Float32Array.from(light.values);
  const read = new Map(aovs.map((name) => [name, name === 'beauty' ? beauty : taken[0]!.aovs.get(name)!]));
  if (!pixels) return { pixels: new Uint8Array(), aovs: read };
  const shown = light.map((x, y) => toneMap(light.at(x, y) as unknown as Vec3, settings.exposure, settings.tone));
  return { pixels: toScreen(Float32Array.from(shown.values), width, height), aovs: read };
}

const dataOf = (images: ReadonlyMap<Layer, Float32Array>, names: readonly AovName[]): Map<AovName, Float32Array> =>
  new Map(names.map((name) => [name, images.get(name)!]));
