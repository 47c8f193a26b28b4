import { msg } from '../messages/message.ts';
import { denoiseWithPool } from '../reference/denoise/denoiseWithPool.ts';
import { prepareScene } from '../reference/intersection/tracedScene.ts';
import { encodeDisplay } from '../reference/post/encodeDisplay.ts';
import { aovsOfFrameGraph, type CapturedBuffers, evaluateFrameGraph } from '../reference/post/frameGraph.ts';
import type { OutputLayer, TileRequest } from '../reference/tileRequest.ts';
import { renderWithPool, TracerPool, tilesOf } from '../reference/tracerPool.ts';
import type { TracerMessage, TracerReply } from '../reference/tracerServer.ts';
import { withDomePicture } from '../scene/film/seenFilm.ts';
import { backdropColors, sceneNightSky, upVector } from '../scene/lights/sceneLights.ts';
import type { DomePicture, Scene } from '../scene/types.ts';
import { drawnFrom } from '../scene/view/drawnFrom.ts';
import { type Lens, lensDirection } from '../scene/view/lenses/lenses.ts';
import type { PictureSize } from '../scene/view/pictureSize.ts';
import { type AovName, bufferSettings, type RenderSettings, type ViewPoint } from '../scene/view/view.ts';
import { toneMap } from '../spectrum/display/toneMap.ts';
import type { PipelineHost, ThreadHost } from './host.ts';
import { renderOneViewAtATime } from './oneViewAtATime.ts';
import type { OptionValuesOf } from './options.ts';
import type { RenderedPicture } from './pictureRenderer.ts';
import { type PictureScenes, PipelineRefusal, type PipelineSession, type SessionRequest } from './pipeline.ts';
import { REFERENCE, type REFERENCE_OPTIONS } from './referenceOptions.ts';

type ReferenceOptions = OptionValuesOf<typeof REFERENCE_OPTIONS>;

/** Opens the reference renderer, which traces rays in f64 on the CPU. */
export function openReferenceSession(
  { scenes, size, speedOfLight, options }: SessionRequest<ReferenceOptions>,
  { threads: host }: PipelineHost,
): PipelineSession {
  const { seed, bounces, mirrors, glass, noiseThreshold, minSamples, denoise } = options;
  const light = { bounces, mirrors, glass };
  const adaptive = noiseThreshold > 0 && { adaptive: { noiseThreshold, minSamples } };
  const threads = Math.min(options.threads ?? host.count(scenes[0]), tilesOf(size).length);
  const pools = new TracerPools(scenes, threads, host);
  // Started now, because threads take a while to start.
  pools.of(0, speedOfLight);
  return {
    info: { pipeline: REFERENCE.id, threads, seed },
    render: (picture, onProgress) =>
      renderOneViewAtATime(
        picture,
        size,
        ({ view, width, height, settings, samples, pixels, aovs }, onPart) => {
          if (settings.ghost !== 'none' || settings.pastFuture)
            throw new PipelineRefusal(
              msg`a ghost, and past and future apart, are drawn by the rasterizer only: switch them off`,
            );
          const request = { width, height, samples, ...adaptive, seed, light };
          const draw: TraceLayers = (scene, own, layers, onLayers) => {
            const from = drawnFrom(view, own);
            const pool = pools.of(scene, own.speedOfLight);
            const all = { ...request, view: from, settings: own, layers };
            return denoise
              ? renderDenoised(pool, all, sceneNightSky(scenes[scene] ?? scenes[0]) !== undefined, onLayers)
              : renderWithPool(pool, all, onLayers);
          };
          return settings.frameGraph
            ? renderFrameGraph(settings, { view, width, height, scenes, pixels, aovs, draw }, onPart)
            : renderLayers(settings, { width, height, pixels, aovs, draw }, onPart);
        },
        onProgress,
      ),
    showDome: { needsMaps: false, show: (scene, { picture }) => pools.showDome(scene, picture) },
    stop: (error) => pools.stop(error),
    close: () => pools.close(),
  };
}

/** Share of the progress that is rendering, if denoising follows. */
const RENDERING = 0.9;

/** As `renderWithPool`; the light is denoised. `hasStars`: see `denoiseWithPool`. */
async function renderDenoised(
  pool: TracerPool,
  request: TileRequest,
  hasStars: boolean,
  onProgress: (fraction: number) => void = () => {},
): Promise<Map<OutputLayer, Float32Array<ArrayBuffer>>> {
  const { layers, settings } = request;
  if (!layers.includes('beauty') && !layers.includes('picture')) return renderWithPool(pool, request, onProgress);
  if (layers.includes('picture') && settings.grid)
    throw new PipelineRefusal(msg`the grid would be denoised with the picture: switch off the grid, or the denoiser`);
  const noisy = { ...request, layers: [...layers, 'denoiser_input'] } as const;
  const images = await renderWithPool(pool, noisy, (part) => onProgress(RENDERING * part));
  const values = images.get('denoiser_input')!;
  const clean = await denoiseWithPool(pool, { values, hasStars }, request, (part) =>
    onProgress(RENDERING + (1 - RENDERING) * part),
  );
  // Light is denoised before it is tone mapped, so that noise does not darken it.
  if (layers.includes('picture')) images.set('picture', displayed(clean, request.view.lens, settings, request));
  return layers.includes('beauty') ? images.set('beauty', clean) : images;
}

/** Starts threads that render a scene with one speed of light [m/s] and share its prepared data. */
export function openTracerPool(scene: Scene, speedOfLight: number, threads: number, host: ThreadHost): TracerPool {
  const { id, name } = REFERENCE;
  const ground = host.share(prepareScene(scene, speedOfLight));
  const started = Array.from({ length: threads }, () => host.start<TracerMessage, TracerReply>(id));
  const message = { kind: 'scene', ground, shapes: host.cacheBytes(threads) } as const;
  return new TracerPool(started, message, (error) => host.explain(error, name));
}

/** Thread pools by scene and speed of light, created lazily. */
class TracerPools {
  private readonly scenes: Scene[];
  private readonly threads: number;
  private readonly host: ThreadHost;
  private readonly open = new Map<string, TracerPool>();

  constructor(scenes: PictureScenes, threads: number, host: ThreadHost) {
    this.scenes = [...scenes];
    this.threads = threads;
    this.host = host;
  }

  of(scene: number, c: number): TracerPool {
    const key = `${scene} ${c}`;
    const pool =
      this.open.get(key) ?? openTracerPool(this.scenes[scene] ?? this.scenes[0]!, c, this.threads, this.host);
    this.open.set(key, pool);
    return pool;
  }

  /** Those that are open, and those to come. */
  showDome(scene: number, picture: DomePicture): void {
    const shared = this.host.share(picture);
    this.scenes[scene] = withDomePicture(this.scenes[scene]!, shared);
    for (const [key, pool] of this.open) if (key.startsWith(`${scene} `)) pool.showDome(shared);
  }

  stop(error: Error): void {
    for (const pool of this.open.values()) pool.stop(error);
  }

  async close(): Promise<void> {
    await Promise.all([...this.open.values()].map((pool) => pool.close()));
  }
}

/** Renders layers of one G-buffer. */
type TraceLayers = (
  scene: number,
  settings: RenderSettings,
  layers: readonly OutputLayer[],
  onPart?: (part: number) => void,
) => Promise<Map<OutputLayer, Float32Array>>;

interface LayerRequest extends PictureSize {
  readonly pixels: boolean;
  readonly aovs: readonly AovName[];
  readonly draw: TraceLayers;
}

async function renderLayers(
  settings: RenderSettings,
  { width, height, pixels, aovs, draw }: LayerRequest,
  onPart?: (part: number) => void,
): Promise<RenderedPicture> {
  const images = await draw(0, settings, pixels ? [...aovs, 'picture'] : aovs, onPart);
  const picture = images.get('picture');
  return { pixels: picture ? encodeDisplay(picture, width, height) : new Uint8Array(), aovs: aovData(images, aovs) };
}

/** Evaluates the frame graph on the mean of the light's samples and on AOVs of the pixels' centres; tone mapping comes last. */
async function renderFrameGraph(
  settings: RenderSettings,
  {
    width,
    height,
    pixels,
    aovs,
    draw,
    view,
    scenes,
  }: LayerRequest & { readonly view: ViewPoint; readonly scenes: PictureScenes },
  onPart: (part: number) => void = () => {},
): Promise<RenderedPicture> {
  const { frameGraph } = settings;
  if (!frameGraph) throw new Error('there is no frame graph to evaluate');
  if (settings.grid)
    throw new PipelineRefusal(
      msg`the grid is drawn by the rasterizer only, where a project puts its picture together: switch it off`,
    );
  // The beauty is the result of the frame graph.
  const data = aovs.filter((name) => name !== 'beauty');
  const needed = aovsOfFrameGraph(frameGraph).map((names, i) => (i === 0 ? [...new Set([...names, ...data])] : names));
  const captured: CapturedBuffers['buffers'][number][] = [];
  for (const [i, names] of needed.entries()) {
    const { frameGraph: _, ...own } = bufferSettings(settings, i);
    const scene = frameGraph.extraBuffers[i - 1]?.scene ?? 0;
    const images = await draw(scene, own, names, (part) => onPart((i + part) / needed.length));
    const of = scenes[scene] ?? scenes[0];
    captured.push({ aovs: aovData(images, names), zenith: upVector(of.upAxis), sky: backdropColors(of) });
  }
  const light = evaluateFrameGraph({ view, settings, width, height, buffers: captured });
  const beauty = Float32Array.from(light.values);
  const requested = new Map(aovs.map((name) => [name, name === 'beauty' ? beauty : captured[0]!.aovs.get(name)!]));
  if (!pixels) return { pixels: new Uint8Array(), aovs: requested };
  const display = displayed(light.values, drawnFrom(view, settings).lens, settings, { width, height });
  return { pixels: encodeDisplay(display, width, height), aovs: requested };
}

/** The tone-mapped picture of light, 3 values per pixel. Blurs reach beyond what a lens shows. */
function displayed(
  light: ArrayLike<number>,
  lens: Lens,
  settings: RenderSettings,
  size: PictureSize,
): Float32Array<ArrayBuffer> {
  const display = new Float32Array(light.length);
  for (let y = 0; y < size.height; y++)
    for (let x = 0; x < size.width; x++) {
      if (!lensDirection(lens, x + 0.5, y + 0.5, size)) continue;
      const i = 3 * (y * size.width + x);
      display.set(toneMap([light[i]!, light[i + 1]!, light[i + 2]!], settings.exposure, settings.tone), i);
    }
  return display;
}

const aovData = (
  images: ReadonlyMap<OutputLayer, Float32Array>,
  names: readonly AovName[],
): Map<AovName, Float32Array> => new Map(names.map((name) => [name, images.get(name)!]));
