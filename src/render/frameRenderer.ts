import type { PerspectiveCamera, RenderTarget } from 'three/webgpu';
import { UnsignedByteType } from 'three/webgpu';
import { type FrameGraph, frameGraphStructure, includesToneMapping } from '../scene/frameGraph/frameGraph.ts';
import type { LightMeterReadings, MeteredQuantities } from '../scene/view/metering.ts';
import type { PictureSize } from '../scene/view/pictureSize.ts';
import type { RenderSettings } from '../scene/view/view.ts';
import type { FalseColorScale } from '../spectrum/falseColor/falseColor.ts';
import type { Capture } from './capture/capture.ts';
import { ColorPipelines } from './color/colorPipelines.ts';
import { type BufferLight, DeferredPass } from './deferredPass.ts';
import { ForwardPass } from './forwardPass.ts';
import type { FrameGraphRunner, PassListener } from './frameGraph/frameGraphRunner.ts';
import { dataTarget, type GBuffer } from './gbuffer/gbuffer.ts';
import { PixelReader } from './gbuffer/pixelReader.ts';
import type { PixelTexels } from './gbuffer/readback.ts';
import type { SpacetimeProjection } from './geometry/vertexStage.ts';
import type { Gpu } from './gpu/device.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import { PassCache } from './gpu/passCache.ts';
import type { FaceGatherer } from './lenses/faceGatherer.ts';
import { drawOpaque } from './opaqueGeometry.ts';
import type { PictureParts } from './pictureParts.ts';
import type { BoundFace, BoundRenderView, PictureSample } from './pictureSample.ts';
import { type DisplaySettings, displayKey } from './post/display/display.ts';
import type { FalseColorTable } from './post/display/falseColor.ts';
import { LightMeter } from './post/display/lightMeter.ts';
import { Antialiasing, type AntialiasingMode } from './post/resolve/antialiasing.ts';
import type { SceneUpload } from './sceneUpload.ts';

/** How a picture is displayed. */
type DisplayState = DisplaySettings & Pick<RenderSettings, 'falseColors' | 'antialiasing' | 'frameGraph'>;

/** Most runners that are kept: the displayed one, one that is being compiled, and the previous one. */
const MAX_RUNNERS = 3;

/** The targets and passes of a picture: G-buffers, lighting, frame graph and display. */
export class FrameRenderer {
  readonly antialiasing: Antialiasing;
  private readonly screen = dataTarget(1, UnsignedByteType);
  private readonly gpu: Gpu;
  private readonly uniforms: FrameUniforms;
  private readonly parts: PictureParts;
  private readonly passes: PassCache;
  private readonly colorPipelines = new ColorPipelines();
  private readonly lightMeter: LightMeter;
  private readonly pixelReader: PixelReader;
  private readonly forwardPass: ForwardPass;
  /** By G-buffer; the first is that of the picture's own settings. */
  private readonly deferredPasses: DeferredPass[] = [];
  /** Of one face of a panoramic picture at a time. */
  private readonly facePasses: DeferredPass[] = [];
  private gatherer: FaceGatherer | undefined;
  /** By G-buffer. */
  private readonly captures: Capture[] = [];
  /** By the structure of their frame graphs; the most recently used is the last. */
  private readonly runners = new Map<string, FrameGraphRunner>();
  private falseColors: FalseColorTable | undefined;
  private size = { width: 1, height: 1 };
  private faceSize = { width: 1, height: 1 };
  /** Light of the last sample. */
  private lastLight: RenderTarget | undefined;
  displayState: DisplayState = { tone: 'neutral', grid: false, hasStars: false, hasUnlit: false, antialiasing: true };
  /** Number of samples whose mean is the light. */
  samples = 1;

  constructor(gpu: Gpu, uniforms: FrameUniforms, parts: PictureParts) {
    this.gpu = gpu;
    this.parts = parts;
    this.uniforms = uniforms;
    this.passes = new PassCache(gpu.renderer);
    this.forwardPass = new ForwardPass(gpu, uniforms, this.colorPipelines, this.passes);
    const light = () => this.light.texture;
    this.antialiasing = new Antialiasing({
      light,
      buffer: this.buffer,
      uniforms,
      runPass: this.passes.run.bind(this.passes),
      makeHistory: (inputs) => new parts.TemporalHistory(inputs),
    });
    this.lightMeter = new LightMeter(gpu, this.buffer, uniforms);
    this.pixelReader = new PixelReader(gpu, this.buffer, this.passes);
  }

  private get light(): RenderTarget {
    return this.lastLight ?? this.deferredPass(0).light();
  }

  get buffer(): GBuffer {
    return this.bufferOf(0);
  }

  bufferOf(index: number): GBuffer {
    return this.deferredPass(index).buffer;
  }

  setSize(width: number, height: number): void {
    this.size = { width, height };
    const { deferredPasses, forwardPass, runners, screen, antialiasing } = this;
    for (const sized of [...deferredPasses, forwardPass, ...runners.values(), screen, antialiasing])
      sized.setSize(width, height);
  }

  /** Draws one sample of a picture that needs no G-buffer. */
  drawForward({ views: [{ view, bind }], camera }: PictureSample): void {
    bind();
    this.lastLight = this.forwardPass.draw(view, camera);
  }

  /** Draws one sample of a picture: its G-buffers, their light and the frame graph; `onPass` is called after each of its passes. */
  draw(sample: PictureSample, onPass?: PassListener): void {
    const { views, captures, faces, camera } = sample;
    for (const { capture, faces: own, awaitsBetter } of captures) capture.take(own, camera, awaitsBetter, drawOpaque);
    const { settings } = views[0].view;
    const { frameGraph } = settings;
    const runner = frameGraph && this.runnerFor(frameGraph);
    const lights = runner ? runner.lights(frameGraph, sample) : [{ buffer: 0, index: 0, lighting: settings }];
    const isGathered = (i: number): boolean => faces.some((face) => face.views[i]);
    faces.forEach((face, i) => {
      this.drawFace(face, views, lights, camera, i > 0);
    });
    const whole = views.map((view, i) => (isGathered(i) ? undefined : view));
    drawSurfaces(whole, lights, camera, (i) => this.deferredPass(i));
    if (isGathered(0)) views[0].bind();
    this.lastLight = runner ? runner.draw(frameGraph, sample, onPass) : this.deferredPass(0).light();
  }

  /** Draws a face with its light, and gathers what the picture shows of it. `over`: it is not the first. */
  private drawFace(
    { face, position, views }: BoundFace,
    pictureViews: PictureSample['views'],
    lights: readonly BufferLight[],
    camera: PerspectiveCamera,
    over: boolean,
  ): void {
    this.setFaceSize(face.size);
    this.gatherer ??= new this.parts.faces.FaceGatherer(this.uniforms, this.passes);
    const { gatherer } = this;
    const own = lights.map((light) => ({ ...light, lighting: { ...light.lighting, occlusionRadius: 0 } }));
    drawSurfaces(views, own, camera, (i) => this.facePass(i));
    gatherer.setFace(face, position);
    views.forEach((view, i) => {
      if (!view) return;
      pictureViews[i].bind();
      const indices = own.flatMap(({ buffer, index }) => (buffer === i ? [index] : []));
      const to = this.deferredPass(i);
      to.setGathered();
      gatherer.gather(this.facePass(i), to, indices, over);
    });
  }

  private setFaceSize({ width, height }: PictureSize): void {
    if (width === this.faceSize.width && height === this.faceSize.height) return;
    this.faceSize = { width, height };
    for (const pass of this.facePasses) pass.setSize(width, height);
  }

  /** The runner of frame graphs of this structure, cached. Call it before `precompile` (gpu/precompile.ts): a new runner draws to initialize its targets. */
  runnerFor(frameGraph: FrameGraph): FrameGraphRunner {
    const structure = frameGraphStructure(frameGraph);
    const cached = this.runners.get(structure);
    const runner =
      cached ?? new this.parts.FrameGraphRunner(frameGraph, this.gpu, this.uniforms, (i) => this.deferredPass(i));
    if (!cached) runner.setSize(this.size.width, this.size.height);
    this.runners.delete(structure);
    this.runners.set(structure, runner);
    const [oldest] = this.runners;
    if (oldest && this.runners.size > MAX_RUNNERS) {
      oldest[1].dispose();
      this.runners.delete(oldest[0]);
    }
    return runner;
  }

  private deferredPass(index: number): DeferredPass {
    return this.pass(this.deferredPasses, index, this.size);
  }

  private facePass(index: number): DeferredPass {
    return this.pass(this.facePasses, index, this.faceSize);
  }

  /** Makes passes up to this index. */
  private pass(passes: DeferredPass[], index: number, { width, height }: PictureSize): DeferredPass {
    while (passes.length <= index) {
      const pass = new DeferredPass(this.gpu, this.uniforms, this.colorPipelines, this.passes);
      passes.push(pass);
      pass.setSize(width, height);
    }
    return passes[index];
  }

  /** The capture of a G-buffer. */
  capture(buffer: number): Capture {
    this.captures[buffer] ??= new this.parts.Capture(this.gpu, this.uniforms);
    return this.captures[buffer];
  }

  /** Forgets what captures hold. */
  resetCaptures(): void {
    for (const capture of this.captures) capture?.reset();
  }

  /** Frees the memory of captures of all but these G-buffers. */
  trimCaptures(used: readonly boolean[]): void {
    this.captures.forEach((capture, i) => {
      if (used[i]) return;
      capture.dispose();
      delete this.captures[i];
    });
  }

  /** Ambient occlusion of the first G-buffer: the unoccluded fraction of the sky, weighted by the cosine. */
  openness(): RenderTarget {
    return this.deferredPass(0).openness();
  }

  /** Runs the display passes, and those of accumulation, so that `precompile` finds their shaders; changes no picture. */
  runDisplayPasses(mode: AntialiasingMode, projection: SpacetimeProjection, where: 'canvas' | 'screen'): void {
    const target = where === 'canvas' ? null : this.screen;
    if (this.displayState.falseColors) this.drawFalseColors(this.displayState, this.displayState.falseColors, target);
    else this.antialiasing.runPasses(mode, this.displayState, projection, target);
  }

  /** Draws the finished picture to the canvas, or to a target that can be read, which is returned. */
  present(where: 'canvas' | 'screen'): RenderTarget {
    const target = where === 'canvas' ? null : this.screen;
    if (this.displayState.falseColors) this.drawFalseColors(this.displayState, this.displayState.falseColors, target);
    else this.antialiasing.present(target);
    return this.screen;
  }

  private drawFalseColors(displayState: DisplayState, colors: FalseColorScale, target: RenderTarget | null): void {
    const { FalseColorTable, falseColored } = this.parts.falseColors;
    this.falseColors ??= new FalseColorTable();
    const { falseColors, buffer, uniforms } = this;
    const { target: lit, index } = this.beauty();
    const light = lit.textures[index];
    falseColors.use(colors);
    const name = `false ${colors.kind} ${displayKey(displayState)} ${light.id}`;
    this.passes.run(name, () => falseColored(colors.kind, light, buffer, uniforms, falseColors, displayState), target);
  }

  /** The target with the light of all samples, and the index of its texture. */
  beauty(): { readonly target: RenderTarget; readonly index: number } {
    return this.samples > 1 ? this.antialiasing.lightMean : { target: this.light, index: 0 };
  }

  /** What a pixel holds; x and y from the top left. */
  readPixel(x: number, y: number): Promise<PixelTexels> {
    const { target, index } = this.beauty();
    return this.pixelReader.read(target.textures[index], x, y);
  }

  /** Samples the picture at positions spread over it; c [m/s]. Only luminance does not need the G-buffer. */
  measureLight(c: number, quantities: MeteredQuantities): Promise<LightMeterReadings> {
    const { target, index } = includesToneMapping(this.displayState.frameGraph)
      ? { target: this.deferredPass(0).light(), index: 0 }
      : this.beauty();
    return this.lightMeter.measure(target.textures[index], target, c, quantities);
  }

  /** Releases the passes that read a scene, and the history. */
  releaseScene(upload: SceneUpload): void {
    this.antialiasing.resetHistory();
    this.resetCaptures();
    this.passes.releaseOwner(upload.serial);
  }

  dispose(): void {
    for (const owned of [
      this.forwardPass,
      ...this.deferredPasses,
      ...this.facePasses,
      ...this.captures.filter(Boolean),
      ...this.runners.values(),
      this.passes,
      this.lightMeter,
      this.pixelReader,
    ])
      owned.dispose();
    this.falseColors?.dispose();
    for (const target of [this.screen, this.antialiasing]) target.dispose();
  }
}

/** Draws G-buffers with their lights, the first one last, so that it stays bound. */
function drawSurfaces(
  views: readonly (BoundRenderView | undefined)[],
  lights: readonly BufferLight[],
  camera: PerspectiveCamera,
  passOf: (buffer: number) => DeferredPass,
): void {
  for (const [buffer, bound] of [...views.entries()].reverse()) {
    if (!bound) continue;
    const { view, bind } = bound;
    bind();
    const pass = passOf(buffer);
    const own = lights.filter((light) => light.buffer === buffer);
    // Made before the G-buffer is drawn, as `DeferredPass.light` demands.
    for (const { index } of own) pass.light(index);
    pass.drawGeometry(view, camera);
    for (const { lighting, index } of own) pass.drawLight(view, camera, lighting, index);
  }
}
