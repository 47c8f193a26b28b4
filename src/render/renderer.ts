import { contentKey, frameGraphStructure } from '../scene/frameGraph/frameGraph.ts';
import type { Scene } from '../scene/types.ts';
import { isPanoramic } from '../scene/view/lenses/lenses.ts';
import { type LightMeterReadings, type MeteredQuantities, mergeReadings } from '../scene/view/metering.ts';
import type { PictureSize } from '../scene/view/pictureSize.ts';
import {
  assertViewports,
  blackPicture,
  composeViews,
  isWholePicture,
  type PictureViews,
  type PixelRect,
  viewPixelAt,
  viewportOf,
} from '../scene/view/pictureViews.ts';
import { AOVS, type AovName, bufferSettings, type RenderSettings } from '../scene/view/view.ts';
import type { RasterRenderer } from './api.ts';
import { colorVariantOf, commonTables } from './color/colorPipelines.ts';
import { FrameSetup, renderViewOf, spacetimeProjectionOf, type ViewBuffers } from './frameSetup.ts';
import { type Gpu, openGpu } from './gpu/device.ts';
import { precompile } from './gpu/precompile.ts';
import type { DomeMaps } from './lights/sky/domeMaps.ts';
import { PictureParts } from './pictureParts.ts';
import type { AntialiasingMode } from './post/resolve/antialiasing.ts';
import { SceneBufferPool } from './sceneBuffers.ts';
import { loadSceneParts, type SceneParts } from './sceneParts.ts';
import { SceneUpload } from './sceneUpload.ts';
import { SceneUploads } from './sceneUploads.ts';
import type {
  BesideOptions,
  PickResult,
  RendererInfo,
  RendererOptions,
  Sampling,
  Shading,
  ShadingChoice,
} from './settings.ts';
import { shadingOf } from './shading/shadingMode.ts';
import { ViewCompositor } from './viewCompositor.ts';
import { canAccumulate, ViewRenderer } from './viewRenderer.ts';

/** The last picture of the first view, for drawing other pictures of it on the same device. */
export interface RenderContext {
  readonly gpu: Gpu;
  readonly frameSetup: FrameSetup;
  readonly parts: PictureParts;
  readonly buffers: ViewBuffers;
}

/** What a picture is drawn of. */
interface DrawRequest {
  readonly views: PictureViews;
  readonly settings: RenderSettings;
  readonly mode: AntialiasingMode;
  readonly shading: ShadingChoice;
}

interface IncompletePicture {
  /** Identifies views, settings and sampling. */
  readonly request: string;
  readonly viewsDrawn: number;
  readonly objectsDrawn: number;
}

const NOTHING_DRAWN = { viewsDrawn: 0, objectsDrawn: 0 };

/**
 * Renders pictures of a scene for a page, a command line or a benchmark; see `RasterRenderer`. The uploaded scenes are
 * shared by all views.
 * @example
 * import { memorySource, openScene } from 'slowlight/formats';
 * import { DEFAULT_SETTINGS, framingCamera, observerFromCamera } from 'slowlight/scene';
 * async function draw(canvas: HTMLCanvasElement, file: Uint8Array) {
 *   const scene = await openScene(memorySource({ 'scene.usda': file }), 'scene.usda');
 *   const renderer = await SceneRenderer.create({ canvas });
 *   await renderer.setScene(scene);
 *   renderer.setSize(960, 540);
 *   const settings = { ...DEFAULT_SETTINGS, speedOfLight: 10 };
 *   const eye = observerFromCamera(framingCamera(scene), 0, settings.speedOfLight);
 *   // An observer at half the speed of light along −Z.
 *   renderer.render([{ ...eye, t: 0, u: [0, 0, -0.577] }], settings);
 * }
 */
export class SceneRenderer implements RasterRenderer {
  shading: ShadingChoice = 'deferred';
  private readonly gpu: Gpu;
  private readonly bufferPool: SceneBufferPool;
  private readonly ownsGpu: boolean;
  private readonly frameSetup = new FrameSetup();
  private readonly pictureParts: PictureParts;
  private readonly compositor: ViewCompositor;
  private readonly toCanvas: boolean;
  private sceneParts: SceneParts = {};
  private readonly uploads: SceneUploads;
  /** By index of the view in the picture. */
  private readonly viewRenderers: ViewRenderer[];
  private last: DrawRequest | undefined;
  /** A picture whose next view waits for motion samples from files; it is resumed there when it is requested again. */
  private incomplete: IncompletePicture | undefined;
  /** Keys of pictures whose shaders are compiled. */
  private readonly compiled = new Set<string>();
  private precompiling: Promise<void> | undefined;
  private readonly disposal = new AbortController();
  /** Of the last picture, and of the next one: the canvas is resized only when that is drawn, because resizing clears it. */
  private size: PictureSize = { width: 1, height: 1 };
  private requestedSize = this.size;
  private lastDraw = { objectsDrawn: 0, milliseconds: 0 };

  /** Opens a GPU. Throws an error that says why where there is none. */
  static async create(options: RendererOptions = {}): Promise<SceneRenderer> {
    const renderer = new SceneRenderer(await openGpu(options), options);
    // Only a page waits for its first picture.
    if (options.canvas) void renderer.computeTables();
    else await renderer.pictureParts.loadAll();
    return renderer;
  }

  /** `first`: the renderer that it is beside. */
  private constructor(gpu: Gpu, options: RendererOptions, first?: SceneRenderer) {
    this.gpu = gpu;
    this.ownsGpu = first === undefined;
    this.bufferPool = first?.bufferPool ?? new SceneBufferPool(gpu);
    this.toCanvas = options.canvas !== undefined;
    this.compositor = new ViewCompositor(gpu.renderer);
    const { uniforms } = this.frameSetup;
    this.pictureParts = new PictureParts(uniforms, options);
    this.viewRenderers = [new ViewRenderer(gpu, this.frameSetup, this.pictureParts)];
    this.uploads = new SceneUploads(
      this.bufferPool,
      (buffers) => new SceneUpload(buffers, uniforms, gpu, options, this.sceneParts),
      (upload) => {
        this.frameSetup.invalidate();
        this.incomplete = undefined;
        for (const view of this.viewRenderers) view.releaseScene(upload);
      },
    );
  }

  /** Computes tables while the first scene is read. */
  private async computeTables(): Promise<void> {
    for (const _ of commonTables()) {
      await new Promise((idle) => setTimeout(idle));
      if (this.disposal.signal.aborted || this.uploads.first) return;
    }
  }

  beside(options: BesideOptions = {}): SceneRenderer {
    return new SceneRenderer(this.gpu, options, this);
  }

  get info(): RendererInfo {
    const { lastDraw, gpu, uploads, pictureParts } = this;
    const { first } = uploads;
    return {
      backend: gpu.backend,
      maxTextureSize: gpu.maxTextureSize,
      shading: this.viewRenderers[0].shading,
      objects: first?.bodies.length ?? 0,
      triangles: first?.tessellator.triangleCount ?? 0,
      tolerance: first?.tessellator.achievedTolerance ?? 0,
      waiting: !uploads.isComplete || pictureParts.isLoading,
      ...lastDraw,
    };
  }
  get width(): number {
    return this.size.width;
  }
  get height(): number {
    return this.size.height;
  }

  async setScene(scene: Scene, others: readonly Scene[] = []): Promise<void> {
    this.sceneParts = await loadSceneParts([scene, ...others], this.sceneParts);
    this.uploads.setScenes([scene, ...others]);
  }

  showDome(maps: DomeMaps, scene = 0): void {
    this.uploads.showDome(scene, maps);
  }

  setSize(width: number, height: number): void {
    this.requestedSize = { width: Math.max(1, Math.round(width)), height: Math.max(1, Math.round(height)) };
    if (!this.viewRenderers[0].hasPicture) this.resize();
  }

  private resize(): void {
    const { width, height } = this.requestedSize;
    if (width === this.width && height === this.height) return;
    this.size = this.requestedSize;
    if (this.toCanvas) this.gpu.renderer.setSize(width, height, false);
  }

  precompile(views: PictureViews, settings: RenderSettings, sampling: Sampling = 1): Promise<void> | undefined {
    const { uploads } = this;
    // Another speed of light may need another upload first.
    if (!uploads.first || uploads.wouldReplace(settings)) return undefined;
    const request = this.requestOf(views, settings, sampling);
    const { pictureParts } = this;
    if (!pictureParts.isReady(views, settings, request.mode)) return pictureParts.load(views, settings, request.mode);
    return this.compileMissing(request);
  }

  private requestOf(views: PictureViews, settings: RenderSettings, sampling: Sampling): DrawRequest {
    return { views, settings, mode: antialiasingModeOf(views, settings, sampling), shading: this.shading };
  }

  /** As `precompile`. */
  private compileMissing(request: DrawRequest): Promise<void> | undefined {
    const pictures = this.buffersOf(request.views, request.settings);
    const shaders = this.shaderKey(request, pictures);
    if (this.compiled.has(shaders)) return undefined;
    this.precompiling ??= this.compile(request, pictures, shaders).finally(() => {
      this.precompiling = undefined;
    });
    return this.precompiling;
  }

  /** `shaders`: their key. */
  private async compile(
    { views, mode, shading }: DrawRequest,
    pictures: readonly ViewBuffers[],
    shaders: string,
  ): Promise<void> {
    const rects = this.viewportsOf(views);
    const prepared = pictures.every((buffers, i) => this.viewRenderer(i).prepare(buffers, rects[i]));
    if (pictures.length === 0 || !prepared) return;
    const target = this.toCanvas && isWholePicture(views) ? 'canvas' : 'screen';
    // Before the first picture only what it shows is compiled.
    if (this.viewRenderers[0].hasScenePicture)
      for (const { upload } of pictures.flat()) upload.tessellator.makeAllPatches();
    const draw = (): void => {
      pictures.forEach((buffers, i) => {
        this.viewRenderer(i).traversePasses(buffers, mode, target, shadingOf(shading, buffers, mode));
      });
    };
    // Also after a failure: a shader that does not compile is reported when it is used.
    await precompile(this.gpu.renderer, draw, this.disposal.signal).finally(() => this.compiled.add(shaders));
  }

  /** Compiles what draws the G-buffers of the last picture, if that was drawn without. */
  private async compileGBuffers(): Promise<void> {
    const { last } = this;
    if (!last || this.drawnViews.every(({ shading }) => shading === 'deferred')) return;
    await this.precompiling;
    await this.compileMissing({ ...last, shading: 'deferred' });
  }

  /** `pictures`: the G-buffers of each view. */
  private shaderKey({ views, settings, mode, shading }: DrawRequest, pictures: readonly ViewBuffers[]): string {
    const shadings = pictures.map((buffers) => shadingOf(shading, buffers, mode));
    return shaderKey(views, settings, mode, shadings, this.uploads.of(settings));
  }

  render(views: PictureViews, settings: RenderSettings, sampling: Sampling = 1): void {
    const start = performance.now();
    assertViewports(views, this.requestedSize);
    const drawn = this.requestOf(views, settings, sampling);
    const { mode, shading } = drawn;
    if (!this.pictureParts.isReady(views, settings, mode)) return;
    const pictures = this.buffersOf(views, settings);
    const rects = this.viewportsOf(views);
    if (pictures.length === 0) return;
    const canWait = pictures.length > 1 && this.uploads.isStreamed;
    const request = canWait ? contentKey([views, settings, sampling]) : undefined;
    const resumed = canWait && this.incomplete?.request === request ? this.incomplete : undefined;
    let { viewsDrawn, objectsDrawn } = resumed ?? NOTHING_DRAWN;
    this.incomplete = undefined;
    for (const [i, buffers] of [...pictures.entries()].slice(viewsDrawn)) {
      const view = this.viewRenderer(i);
      const visible = view.prepare(buffers, rects[i], () => {
        this.resize();
        view.setViewport(rects[i]);
      });
      if (!visible) {
        if (request !== undefined) this.incomplete = { request, viewsDrawn, objectsDrawn };
        return;
      }
      view.draw(buffers, mode, sampling, shadingOf(shading, buffers, mode));
      viewsDrawn++;
      objectsDrawn += visible.filter(Boolean).length;
    }
    this.last = drawn;
    // A picture that is being compiled may have more views, and more G-buffers.
    if (!this.precompiling) for (const unused of this.viewRenderers.splice(views.length)) unused.dispose();
    if (this.toCanvas) this.presentOnCanvas();
    this.lastDraw = { objectsDrawn, milliseconds: performance.now() - start };
    this.compiled.add(this.shaderKey(drawn, pictures));
    if (!this.precompiling) this.uploads.trim(pictures[0].length);
    // Trimming may have cleared the views' last buffers, but this picture's uploads are still there.
    pictures.forEach((buffers, i) => {
      this.viewRenderer(i).keep(buffers);
    });
    if (this.toCanvas) pictures[0][0].upload.tessellator.countPeriodically();
  }

  /** The G-buffers of each view; empty without a scene. */
  private buffersOf(views: PictureViews, settings: RenderSettings): readonly ViewBuffers[] {
    const uploads = this.uploads.of(settings);
    return views.flatMap((view, viewIndex) => {
      const [first, ...others] = uploads.map((upload, i) =>
        renderViewOf(upload, view, viewIndex, bufferSettings(settings, i), () =>
          this.viewRenderer(viewIndex).capture(i),
        ),
      );
      return first ? [[first, ...others] as const] : [];
    });
  }

  private viewportsOf(views: PictureViews): readonly PixelRect[] {
    return views.map((view) => viewportOf(view, this.requestedSize));
  }

  private viewRenderer(index: number): ViewRenderer {
    while (this.viewRenderers.length <= index)
      this.viewRenderers.push(new ViewRenderer(this.gpu, this.frameSetup, this.pictureParts));
    return this.viewRenderers[index];
  }

  /** Those of the last picture; one that is being compiled may have more. */
  private get drawnViews(): readonly ViewRenderer[] {
    return this.viewRenderers.slice(0, this.last?.views.length ?? 1);
  }

  private presentOnCanvas(): void {
    const { drawnViews, last } = this;
    if (last && isWholePicture(last.views)) drawnViews[0].presentOnCanvas();
    else this.compositor.present(drawnViews.map((view) => ({ target: view.present(), rect: view.viewport })));
  }

  accumulate(n: number): boolean {
    const samples = this.drawnViews.map((view) => view.accumulate(n));
    if (this.toCanvas && samples.some(({ added }) => added)) this.presentOnCanvas();
    return samples.some(({ more }) => more);
  }

  async readPixels(): Promise<Uint8Array> {
    await this.uploads.first?.tessellator.count();
    return this.readViews(
      (view) => view.readPixels(),
      4,
      () => blackPicture(this.size),
    );
  }

  async readAov(name: AovName): Promise<Float32Array> {
    await this.compileGBuffers();
    const { length: channels } = AOVS[name].channels;
    const empty = () => new Float32Array(channels * this.width * this.height);
    return this.readViews((view) => view.readAov(name), channels, empty);
  }

  /** Reads all views, `channels` values per pixel, into their viewports of `background`. */
  private async readViews<Values extends Float32Array | Uint8Array>(
    read: (view: ViewRenderer) => Promise<Values>,
    channels: number,
    background: () => Values,
  ): Promise<Values> {
    if (!this.last || isWholePicture(this.last.views)) return read(this.viewRenderers[0]);
    const parts: { rect: PixelRect; values: Values }[] = [];
    for (const view of this.drawnViews) parts.push({ rect: view.viewport, values: await read(view) });
    return composeViews(parts, this.size, channels, background());
  }

  async pick(x: number, y: number): Promise<PickResult | undefined> {
    const upload = this.uploads.first;
    const found = this.last && viewPixelAt(this.last.views, this.size, x, y);
    if (!upload || !found) return undefined;
    await this.compileGBuffers();
    return this.viewRenderers[found.index].pick(upload, Math.floor(found.x), Math.floor(found.y));
  }

  async measureLight(quantities: MeteredQuantities = 'all'): Promise<LightMeterReadings> {
    if (quantities === 'all') await this.compileGBuffers();
    const parts: { rect: PixelRect; readings: LightMeterReadings }[] = [];
    for (const view of this.drawnViews)
      parts.push({ rect: view.viewport, readings: await view.measureLight(quantities) });
    return mergeReadings(parts, this.size);
  }

  /**
   * Loads what runs frame graphs.
   * @internal
   */
  loadFrameGraphs(): Promise<void> {
    return this.pictureParts.loadFrameGraphs();
  }

  /**
   * Prepares the last picture of the first view, calls `use` with it, which may draw on the same device (previews.ts), and restores the uniforms
   * afterwards. Returns undefined if there is no picture.
   * @internal
   */
  withLastView<Made>(use: (context: RenderContext) => Made): Made | undefined {
    const { gpu, frameSetup } = this;
    const [view] = this.viewRenderers;
    const buffers = view.restore();
    if (!buffers) return undefined;
    try {
      return use({ gpu, frameSetup, parts: this.pictureParts, buffers });
    } finally {
      frameSetup.setView(buffers[0], view.viewport);
    }
  }

  dispose(): void {
    this.disposal.abort();
    this.uploads.trim(0);
    for (const view of this.viewRenderers) view.dispose();
    this.compositor.dispose();
    if (this.ownsGpu) this.gpu.renderer.dispose();
  }
}

function antialiasingModeOf(views: PictureViews, settings: RenderSettings, sampling: Sampling): AntialiasingMode {
  // The history is reprojected through frusta.
  const hasFrusta = views.every(({ lens }) => !isPanoramic(lens));
  if (sampling === 'temporal' && hasFrusta && canAccumulate(settings)) return 'temporal';
  if (sampling !== 'temporal' && sampling > 1) return 'mean';
  return settings.antialiasing ? 'fxaa' : 'none';
}

/** Identifies the shaders of a picture: equal keys need the same shaders. */
function shaderKey(
  views: PictureViews,
  settings: RenderSettings,
  mode: AntialiasingMode,
  shadings: readonly Shading[],
  uploads: readonly SceneUpload[],
): string {
  const { tone, grid, falseColors, shadows, occlusionRadius, frameGraph, ghost, pastFuture } = settings;
  const buffers = uploads.map(({ serial, scene }, i) => {
    const own = bufferSettings(settings, i);
    const { event, place } = spacetimeProjectionOf(own);
    return [serial, event, place, colorVariantOf(own, scene), own.capture !== undefined].join(' ');
  });
  const shape = frameGraph && frameGraphStructure(frameGraph);
  const display = [tone, grid, ghost !== 'none', pastFuture, falseColors?.kind ?? mode];
  const lenses = views.map(({ lens }) => isPanoramic(lens)).join(' ');
  return [...buffers, lenses, ...shadings, shadows, occlusionRadius !== 0, ...display, shape].join(' ');
}
