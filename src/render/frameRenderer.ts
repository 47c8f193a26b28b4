import type { PerspectiveCamera, RenderTarget } from 'three/webgpu';
import { UnsignedByteType } from 'three/webgpu';
import { type FrameGraph, frameGraphStructure, includesToneMapping } from '../scene/frameGraph/frameGraph.ts';
import type { LightMeterReadings } from '../scene/view/metering.ts';
import type { RenderSettings } from '../scene/view/view.ts';
import type { FalseColorScale } from '../spectrum/falseColor/falseColor.ts';
import { ColorPipelines } from './color/colorPipelines.ts';
import { DeferredPass } from './deferredPass.ts';
import { type BoundRenderView, FrameGraphRunner, type PassListener } from './frameGraph/frameGraphRunner.ts';
import { dataTarget, type GBuffer } from './gbuffer/gbuffer.ts';
import type { SpacetimeProjection } from './geometry/vertexStage.ts';
import type { Gpu } from './gpu/device.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import { PassCache } from './gpu/passCache.ts';
import type { DisplaySettings } from './post/display/display.ts';
import { FalseColorTable, falseColored } from './post/display/falseColor.ts';
import { LightMeter } from './post/display/lightMeter.ts';
import { Antialiasing, type AntialiasingMode } from './post/resolve/antialiasing.ts';
import type { SceneUpload } from './sceneUpload.ts';

/** How a picture is shown. */
type DisplayState = DisplaySettings & Pick<RenderSettings, 'falseColors' | 'antialiasing' | 'frameGraph'>;

/** So many compositions are kept: what is shown, what is being compiled, and what was shown before. */
const MAX_RUNNERS = 3;

/** The targets and passes of a picture of one size: G-buffers with their light, what a plan makes of it, display. */
export class FrameRenderer {
  readonly antialiasing: Antialiasing;
  private readonly screen = dataTarget(1, UnsignedByteType);
  private readonly gpu: Gpu;
  private readonly uniforms: FrameUniforms;
  private readonly passes: PassCache;
  private readonly colorPipelines = new ColorPipelines();
  private readonly lightMeter: LightMeter;
  /** The first is that of the picture itself. */
  private readonly deferredPasses: DeferredPass[] = [];
  /** By the shape of their plans; the last that was drawn at the end. */
  private readonly runners = new Map<string, FrameGraphRunner>();
  private readonly falseColors = new FalseColorTable();
  private size = { width: 1, height: 1 };
  /** Where the light of the last sample is. */
  private light: RenderTarget;
  /** How the picture that is there is to be shown; of how many samples its light is. */
  displayState: DisplayState = { tone: 'neutral', grid: false, hasStars: false, antialiasing: true };
  samples = 1;

  constructor(gpu: Gpu, uniforms: FrameUniforms) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.passes = new PassCache(gpu.renderer);
    this.light = this.deferredPass(0).light();
    const light = () => this.light.texture;
    this.antialiasing = new Antialiasing({
      light,
      buffer: this.buffer,
      uniforms,
      runPass: this.passes.run.bind(this.passes),
    });
    this.lightMeter = new LightMeter(gpu, this.buffer, uniforms);
  }

  get buffer(): GBuffer {
    return this.bufferOf(0);
  }

  bufferOf(index: number): GBuffer {
    return this.deferredPass(index).buffer;
  }

  setSize(width: number, height: number): void {
    this.size = { width, height };
    for (const sized of [...this.deferredPasses, ...this.runners.values(), this.screen, this.antialiasing])
      sized.setSize(width, height);
  }

  /** One sample of a picture: its G-buffers and their light, and what its plan makes of them; `seen` is told of each of its steps. */
  draw(
    sittings: readonly [BoundRenderView, ...BoundRenderView[]],
    camera: PerspectiveCamera,
    time: number,
    seen?: PassListener,
  ): void {
    const [first] = sittings;
    const { frameGraph } = first.view.settings;
    if (frameGraph) {
      this.light = this.runnerFor(frameGraph).draw(frameGraph, { views: sittings, camera, time }, seen);
      return;
    }
    const plate = this.deferredPass(0);
    plate.drawGeometry(first.view, camera);
    plate.drawLight(first.view, camera, first.view.settings);
    this.light = plate.light();
  }

  /** What carries out plans of this shape; to be asked for before it is gone through without being drawn (precompile.ts), for it draws to targets to make them. */
  runnerFor(plan: FrameGraph): FrameGraphRunner {
    const shape = frameGraphStructure(plan);
    const known = this.runners.get(shape);
    const composition = known ?? new FrameGraphRunner(plan, this.gpu, this.uniforms, (i) => this.deferredPass(i));
    if (!known) composition.setSize(this.size.width, this.size.height);
    this.runners.delete(shape);
    this.runners.set(shape, composition);
    const [oldest] = this.runners;
    if (oldest && this.runners.size > MAX_RUNNERS) {
      oldest[1].dispose();
      this.runners.delete(oldest[0]);
    }
    return composition;
  }

  private deferredPass(index: number): DeferredPass {
    while (this.deferredPasses.length <= index) {
      const plate = new DeferredPass(this.gpu, this.uniforms, this.colorPipelines, this.passes);
      this.deferredPasses.push(plate);
      plate.setSize(this.size.width, this.size.height);
    }
    return this.deferredPasses[index];
  }

  /** The share of the sky that each point of what is in the first G-buffer sees. */
  openness(): RenderTarget {
    return this.deferredPass(0).openness();
  }

  /** Goes through what makes a picture of its light, and pictures at rest of many, without making any. */
  runDisplayPasses(way: AntialiasingMode, projection: SpacetimeProjection, where: 'canvas' | 'screen'): void {
    const target = where === 'canvas' ? null : this.screen;
    if (this.displayState.falseColors) this.drawFalseColors(this.displayState, this.displayState.falseColors, target);
    else this.antialiasing.runPasses(way, this.displayState, projection, target);
  }

  /** The finished picture to the canvas (`null`), or to where it can be read. */
  present(where: 'canvas' | 'screen'): RenderTarget {
    const target = where === 'canvas' ? null : this.screen;
    if (this.displayState.falseColors) this.drawFalseColors(this.displayState, this.displayState.falseColors, target);
    else this.antialiasing.present(target);
    return this.screen;
  }

  private drawFalseColors(look: DisplayState, colors: FalseColorScale, target: RenderTarget | null): void {
    const { falseColors, buffer, uniforms } = this;
    const { target: lit, index } = this.beauty();
    const light = lit.textures[index];
    falseColors.use(colors);
    const name = `false ${colors.kind} ${look.tone} ${look.grid} ${light.id}`;
    this.passes.run(name, () => falseColored(colors.kind, light, buffer, uniforms, falseColors, look), target);
  }

  /** Where the light of the whole picture is, and in which of its textures. */
  beauty(): { readonly target: RenderTarget; readonly index: number } {
    return this.samples > 1 ? this.antialiasing.lightMean : { target: this.light, index: 0 };
  }

  /** What the picture is like at places spread over it; c [m/s]. */
  measureLight(c: number): Promise<LightMeterReadings> {
    const { target, index } = includesToneMapping(this.displayState.frameGraph)
      ? { target: this.deferredPass(0).light(), index: 0 }
      : this.beauty();
    return this.lightMeter.measure(target.textures[index], target.width, target.height, c);
  }

  /** Lets go of the passes that read a scene. */
  releaseScene(upload: SceneUpload): void {
    this.antialiasing.resetHistory();
    this.passes.releaseOwner(upload.serial);
  }

  dispose(): void {
    for (const held of [...this.deferredPasses, ...this.runners.values(), this.passes, this.lightMeter]) held.dispose();
    this.falseColors.dispose();
    for (const target of [this.screen, this.antialiasing]) target.dispose();
  }
}
