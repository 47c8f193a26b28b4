import { frameGraphStructure } from '../scene/frameGraph/frameGraph.ts';
import type { Scene } from '../scene/types.ts';
import type { LightMeterReadings } from '../scene/view/metering.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view/view.ts';
import { bufferSettings } from '../scene/view/view.ts';
import type { RasterRenderer } from './api.ts';
import { colorVariantOf } from './color/colorPipelines.ts';
import { FrameRenderer } from './frameRenderer.ts';
import { FrameSetup, type RenderView, renderViewOf, spacetimeProjectionOf } from './frameSetup.ts';
import { type Region, readBytes, readData, readFloats, readSurfaceAt } from './gbuffer/readback.ts';
import type { Observation } from './geometry/observation.ts';
import { type Gpu, openGpu } from './gpu/device.ts';
import { precompile } from './gpu/precompile.ts';
import type { AntialiasingMode } from './post/resolve/antialiasing.ts';
import { gridPositions, haltonPosition, PIXEL_CENTER, type SamplePosition } from './post/resolve/pixelSamples.ts';
import { SceneUpload } from './sceneUpload.ts';
import { SceneUploads } from './sceneUploads.ts';
import type { PickResult, RendererInfo, RendererOptions, Sampling } from './settings.ts';

/** Of so many samples a picture is better than one that was smoothed otherwise. */
const MIN_MEAN_SAMPLES = 8;

/** All that a picture is made of: its G-buffers, that of the settings first. */
type RenderViews = readonly [RenderView, ...RenderView[]];

/** What others may make pictures of, as long as they are lent it. */
export interface RenderContext {
  readonly gpu: Gpu;
  readonly frameSetup: FrameSetup;
  readonly views: RenderViews;
}

/** Makes pictures of a scene for a page, a command line or a benchmark; see api.ts. */
export class SceneRenderer implements RasterRenderer {
  private readonly gpu: Gpu;
  private readonly frameSetup = new FrameSetup();
  private readonly frameRenderer: FrameRenderer;
  private readonly toCanvas: boolean;
  private readonly uploads: SceneUploads;
  /** What pictures have been drawn with, or can be at once. */
  private readonly compiled = new Set<string>();
  private precompiling: Promise<void> | undefined;
  private lastObservation: Observation | undefined;
  /** Of the last picture, and of the next one: the size changes when that is made, for a canvas of a new size is empty. */
  private size = { width: 1, height: 1 };
  private requestedSize = this.size;
  private lastViews: RenderViews | undefined;
  /** What uniforms, tables and shadow maps are of. */
  private preparedViews: RenderViews | undefined;
  /** Samples of the last picture that `refine` has added. */
  private addedSamples = 0;
  /** The G-buffer and the light are those of the pixels' centres. */
  private isPixelCentered = true;
  private frameCount = 0;
  private lastDraw = { objectsDrawn: 0, milliseconds: 0 };

  static async create(options: RendererOptions = {}): Promise<SceneRenderer> {
    return new SceneRenderer(await openGpu(options), options);
  }

  private constructor(gpu: Gpu, options: RendererOptions) {
    this.gpu = gpu;
    this.toCanvas = options.canvas !== undefined;
    const { uniforms } = this.frameSetup;
    this.frameRenderer = new FrameRenderer(gpu, uniforms);
    this.uploads = new SceneUploads(
      (scene, speedOfLight) => new SceneUpload(scene, speedOfLight, uniforms, gpu, options),
      (upload) => {
        this.lastViews = undefined;
        this.preparedViews = undefined;
        this.frameRenderer.releaseScene(upload);
      },
    );
  }

  get info(): RendererInfo {
    const { lastDraw: drawn, gpu, uploads } = this;
    const { first } = uploads;
    const triangles = first?.tessellator.triangleCount ?? 0;
    const tolerance = first?.tessellator.achievedTolerance ?? 0;
    const waiting = !uploads.isComplete;
    const { backend, maxTextureSize: largest } = gpu;
    return {
      backend,
      maxTextureSize: largest,
      objects: first?.bodies.length ?? 0,
      triangles,
      tolerance,
      waiting,
      ...drawn,
    };
  }
  get width(): number {
    return this.size.width;
  }
  get height(): number {
    return this.size.height;
  }

  async setScene(scene: Scene, others: readonly Scene[] = []): Promise<void> {
    this.uploads.setScenes([scene, ...others]);
  }

  setSize(width: number, height: number): void {
    this.requestedSize = { width: Math.max(1, Math.round(width)), height: Math.max(1, Math.round(height)) };
    if (!this.lastObservation) this.resize();
  }

  private resize(): void {
    const { width, height } = this.requestedSize;
    if (width === this.width && height === this.height) return;
    this.size = this.requestedSize;
    this.gpu.renderer.setSize(width, height, false);
    this.frameRenderer.setSize(width, height);
    this.lastObservation = undefined;
  }

  precompile(viewPoint: ViewPoint, settings: RenderSettings, sampling: Sampling = 1): Promise<void> | undefined {
    const { uploads } = this;
    // With another speed of light it may be another upload's turn.
    if (!uploads.first || uploads.wouldReplace(settings)) return undefined;
    const way = antialiasingModeOf(settings, sampling);
    if (this.compiled.has(shaderKey(settings, way, uploads.of(settings)))) return undefined;
    this.precompiling ??= this.compile(viewPoint, settings, way).finally(() => {
      this.precompiling = undefined;
    });
    return this.precompiling;
  }

  private async compile(viewPoint: ViewPoint, settings: RenderSettings, way: AntialiasingMode): Promise<void> {
    const motifs = this.viewsOf(viewPoint, settings);
    if (!motifs || !this.prepareFrame(motifs)) return;
    const draw = (): void => {
      this.draw(motifs, PIXEL_CENTER);
      this.frameRenderer.runDisplayPasses(way, motifs[0].projection, this.toCanvas ? 'canvas' : 'screen');
    };
    const shaders = shaderKey(settings, way, this.uploads.of(settings));
    // Whatever comes of it: a shader that cannot be compiled is told of when it is to be drawn with.
    await precompile(this.gpu.renderer, draw).finally(() => this.compiled.add(shaders));
  }

  render(viewPoint: ViewPoint, settings: RenderSettings, sampling: Sampling = 1): void {
    const began = performance.now();
    const motifs = this.viewsOf(viewPoint, settings);
    const seen = motifs && this.prepareFrame(motifs, () => this.resize());
    if (!motifs || !seen) return;
    const [{ upload, observation }] = motifs;
    this.lastViews = motifs;
    this.addedSamples = 0;
    const way = antialiasingModeOf(settings, sampling);
    if (way === 'followed') this.drawTemporal(motifs);
    else this.drawSamples(motifs, way === 'mean' ? Number(sampling) : 1);
    if (this.toCanvas) this.frameRenderer.present('canvas');
    this.lastObservation = observation;
    this.lastDraw = { objectsDrawn: seen.filter(Boolean).length, milliseconds: performance.now() - began };
    this.compiled.add(shaderKey(settings, way, this.uploads.of(settings)));
    // While a picture is being compiled, its G-buffers are.
    if (!this.precompiling) this.uploads.trim(motifs.length);
    // What was let go of is not of this picture: that can be drawn again.
    this.lastViews = motifs;
    if (this.toCanvas) upload.tessellator.countPeriodically();
  }

  private viewsOf(viewPoint: ViewPoint, settings: RenderSettings): RenderViews | undefined {
    const [first, ...others] = this.uploads
      .of(settings)
      .map((upload, i) => renderViewOf(upload, viewPoint, bufferSettings(settings, i)));
    return first && [first, ...others];
  }

  /** Puts everything in its place for a picture; tells which bodies of the first scene may be seen, or undefined where samples are still to come. */
  private prepareFrame(motifs: RenderViews, ready?: () => void): readonly boolean[] | undefined {
    const [{ settings, upload }] = motifs;
    this.preparedViews = undefined;
    this.frameRenderer.displayState = { ...settings, hasStars: upload.stars !== undefined };
    let seen: readonly boolean[] | undefined;
    // The first comes last: its uniforms stay.
    for (const motif of [...motifs].reverse()) {
      seen = this.frameSetup.prepareFrame(motif, this.requestedSize, ready);
      if (!seen) return undefined;
    }
    if (settings.frameGraph) this.frameRenderer.runnerFor(settings.frameGraph).updateStills(settings.frameGraph);
    this.preparedViews = motifs;
    return seen;
  }

  /** Puts everything back in its place for the last picture, where another was staged since; tells whether it can be drawn again. */
  private prepareLastFrame(): RenderViews | undefined {
    const { lastViews: made, preparedViews } = this;
    return made && (preparedViews === made || this.prepareFrame(made)) ? made : undefined;
  }

  accumulate(n: number): boolean {
    const { frameRenderer, addedSamples } = this;
    const count = n * n;
    if (
      addedSamples === count ||
      frameRenderer.samples > 1 ||
      !this.lastViews ||
      !isProgressive(this.lastViews[0].settings)
    )
      return false;
    const made = this.prepareLastFrame();
    if (!made) return true;
    this.drawSample(made, gridPositions(n)[addedSamples]);
    this.addedSamples = addedSamples + 1;
    frameRenderer.antialiasing.addSample(
      addedSamples,
      count,
      frameRenderer.displayState,
      this.addedSamples >= Math.min(MIN_MEAN_SAMPLES, count),
    );
    if (this.toCanvas) frameRenderer.present('canvas');
    return this.addedSamples < count;
  }

  /** n × n samples per pixel. */
  private drawSamples(motifs: RenderViews, n: number): void {
    const { frameRenderer } = this;
    frameRenderer.samples = n * n;
    for (const [i, place] of gridPositions(n).entries()) {
      this.drawSample(motifs, place);
      if (n > 1) frameRenderer.antialiasing.addSample(i, n * n, frameRenderer.displayState, true);
    }
    if (frameRenderer.displayState.falseColors) this.drawPixelCenters();
    else if (n === 1) frameRenderer.antialiasing.resolveSingle(frameRenderer.displayState);
  }

  /** One sample, and what is left of the pictures before. */
  private drawTemporal(motifs: RenderViews): void {
    const { frameRenderer } = this;
    frameRenderer.samples = 1;
    this.drawSample(motifs, haltonPosition(this.frameCount++));
    frameRenderer.antialiasing.resolveTemporal(frameRenderer.displayState, {
      ...motifs[0],
      aspect: this.width / this.height,
    });
  }

  private drawSample(motifs: RenderViews, place: SamplePosition): void {
    this.draw(motifs, place);
    this.isPixelCentered = place[0] === 0 && place[1] === 0;
  }

  /** Draws what is staged with its samples at one place of their pixels. */
  private draw([first, ...others]: RenderViews, place: SamplePosition): void {
    const { frameSetup, size } = this;
    frameSetup.jitter(place, size);
    const bound = (view: RenderView) => ({ view, bind: () => frameSetup.setView(view, size) });
    this.frameRenderer.draw([bound(first), ...others.map(bound)], frameSetup.camera, first.viewPoint.t);
  }

  /** Numbers are of the pixels' centres, and never a mean. */
  private drawPixelCenters(): void {
    const made = this.isPixelCentered ? undefined : this.prepareLastFrame();
    if (made) this.drawSample(made, PIXEL_CENTER);
  }

  async readPixels(): Promise<Uint8Array> {
    await this.uploads.first?.tessellator.count();
    this.prepareLastFrame();
    return readBytes(this.gpu, this.frameRenderer.present('screen'), this.wholeRegion());
  }

  async readAov(name: AovName): Promise<Float32Array> {
    this.drawPixelCenters();
    if (name !== 'beauty')
      return readData(this.gpu, this.frameRenderer, name, this.requireObservation(), this.wholeRegion());
    const { target, index } = this.frameRenderer.beauty();
    return withoutAlpha(await readFloats(this.gpu, target, index, this.wholeRegion()));
  }

  async pick(x: number, y: number): Promise<PickResult | undefined> {
    const inside = x >= 0 && y >= 0 && x < this.width && y < this.height;
    const { lastObservation: taken } = this;
    const upload = this.uploads.first;
    if (!inside || !upload || !taken) return undefined;
    this.drawPixelCenters();
    const pathOf = (id: number) => upload.bodies[id - 1].object.path;
    const [column, row] = [Math.floor(x), Math.floor(y)];
    const { target, index } = this.frameRenderer.beauty();
    const [light, surface] = await Promise.all([
      readFloats(this.gpu, target, index, { x: column, y: row, width: 1, height: 1 }),
      readSurfaceAt(this.gpu, this.frameRenderer, taken, pathOf, column, row),
    ]);
    return { light: [light[0], light[1], light[2]], ...(surface && { surface }) };
  }

  async measureLight(): Promise<LightMeterReadings> {
    this.drawPixelCenters();
    return this.frameRenderer.measureLight(this.requireObservation().c);
  }

  /**
   * Lends what the last picture was made of, all in its place, to who makes others of it on the same device (previews.ts); then everything is as it was.
   * Undefined where there is none.
   */
  withLastView<Made>(use: (set: RenderContext) => Made): Made | undefined {
    const { gpu, frameSetup } = this;
    const motifs = this.prepareLastFrame();
    if (!motifs) return undefined;
    try {
      return use({ gpu, frameSetup, views: motifs });
    } finally {
      frameSetup.setView(motifs[0], this.size);
    }
  }

  dispose(): void {
    this.uploads.trim(0);
    this.frameRenderer.dispose();
    this.gpu.renderer.dispose();
  }

  private requireObservation(): Observation {
    if (!this.lastObservation) throw new Error('nothing has been rendered yet');
    return this.lastObservation;
  }

  private wholeRegion(): Region {
    return { x: 0, y: 0, width: this.width, height: this.height };
  }
}

/** Whether its pictures come to more samples while they rest: colours that stand for numbers never do. */
const isProgressive = ({ antialiasing, falseColors }: RenderSettings): boolean => antialiasing && !falseColors;

function antialiasingModeOf(settings: RenderSettings, sampling: Sampling): AntialiasingMode {
  if (sampling === 'temporal' && isProgressive(settings)) return 'followed';
  if (sampling !== 'temporal' && sampling > 1) return 'mean';
  return settings.antialiasing ? 'edges' : 'plain';
}

/** Names all the shaders that a picture takes. */
function shaderKey(settings: RenderSettings, way: AntialiasingMode, uploads: readonly SceneUpload[]): string {
  const { tone, grid, falseColors, shadows, occlusionRadius, frameGraph } = settings;
  const buffers = uploads.map(({ serial, scene }, i) => {
    const own = bufferSettings(settings, i);
    const { event, place } = spacetimeProjectionOf(own);
    return [serial, event, place, colorVariantOf(own, scene)].join(' ');
  });
  const shape = frameGraph && frameGraphStructure(frameGraph);
  return [...buffers, shadows, occlusionRadius !== 0, tone, grid, falseColors?.kind ?? way, shape].join(' ');
}

function withoutAlpha(rgba: Float32Array): Float32Array {
  const out = new Float32Array((rgba.length / 4) * 3);
  for (let i = 0; i < rgba.length / 4; i++) for (let k = 0; k < 3; k++) out[3 * i + k] = rgba[4 * i + k];
  return out;
}
