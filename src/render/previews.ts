import { Fn, select, uniform, vec4 } from 'three/tsl';
import { type RenderTarget, type Texture, UnsignedByteType } from 'three/webgpu';
import { type FrameGraph, frameGraphStructure } from '../scene/frameGraph/frameGraph.ts';
import type { PictureSize } from '../scene/view/pictureViews.ts';
import { bufferSettings } from '../scene/view/view.ts';
import { toneMaps } from '../shaders/color/toneMap.ts';
import type { Vec4 } from '../shaders/types.ts';
import type { BoundRenderView } from './frameGraph/frameGraphRunner.ts';
import { FrameRenderer } from './frameRenderer.ts';
import { dataTarget } from './gbuffer/gbuffer.ts';
import { readBytes } from './gbuffer/readback.ts';
import type { Gpu } from './gpu/device.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import { texelHere } from './gpu/fullScreenPass.ts';
import { PassCache } from './gpu/passCache.ts';
import { precompile } from './gpu/precompile.ts';
import { encodeSrgb } from './post/display/display.ts';
import { LightMeter } from './post/display/lightMeter.ts';
import { PIXEL_CENTER } from './post/resolve/pixelSamples.ts';
import type { RenderContext, SceneRenderer } from './renderer.ts';
import type { SceneUpload } from './sceneUpload.ts';

/** What of a plan is to be looked at. */
export type PreviewRequest =
  /** The image of a step. `exposure` [EV]: of light that no tone curve was over yet; absent: it is 0 … 1 already. */
  | { readonly kind: 'image'; readonly step: number; readonly exposure?: number }
  /** The luminance of a step's light, at as many places as exposure is metered at. */
  | { readonly kind: 'luminance'; readonly step: number }
  /** The colours of the surfaces in a G-buffer; clear where there are none. */
  | { readonly kind: 'albedo'; readonly buffer: number };

/** Rows from the top: sRGB, RGBA8; or luminances. */
export type Preview = Uint8Array | Float32Array;

/**
 * Small pictures of the steps of a plan: drawn by the passes of the picture that is shown, of its scenes as they are staged for it, into targets of their own.
 * Nothing of that picture, its samples or its history changes.
 */
export class PreviewRenderer {
  private readonly renderer: SceneRenderer;
  private targets: PreviewTargets | undefined;
  /** What the shaders that are ready depend on. */
  private compiledKey = '';

  constructor(renderer: SceneRenderer) {
    this.renderer = renderer;
  }

  /**
   * In the order of what is asked for. `plan`: its G-buffers are those of the picture that is shown, in that order. New shaders are compiled between the
   * frames of others. Undefined where there is nothing that previews could be made of. One at a time.
   */
  async make(
    plan: FrameGraph,
    of: readonly PreviewRequest[],
    size: PictureSize,
  ): Promise<readonly Preview[] | undefined> {
    await this.renderer.withLastView((set) => this.precompiled(plan, of, this.targetsFor(set, size), set));
    const reading = this.renderer.withLastView((set) => {
      const read: Promise<Preview>[] = [];
      this.targetsFor(set, size).draw(plan, of, set, (i, made) => {
        read[i] = made();
      });
      return read;
    });
    return reading && Promise.all(reading);
  }

  dispose(): void {
    this.targets?.dispose();
  }

  private targetsFor({ gpu, frameSetup, buffers }: RenderContext, size: PictureSize): PreviewTargets {
    this.targets ??= new PreviewTargets(gpu, frameSetup.uniforms);
    this.targets.prepare(
      size,
      buffers.map(({ upload }) => upload),
    );
    return this.targets;
  }

  private precompiled(
    plan: FrameGraph,
    of: readonly PreviewRequest[],
    desk: PreviewTargets,
    set: RenderContext,
  ): Promise<void> | undefined {
    const shaders = [frameGraphStructure(plan), ...set.buffers.map(({ upload }) => upload.serial)].join(' ');
    if (shaders === this.compiledKey) return undefined;
    this.compiledKey = shaders;
    desk.setFrameGraph(plan);
    return precompile(set.gpu.renderer, () => desk.draw(plan, of, set, () => {}));
  }
}

/** Is told that what was asked for at place `i` is there, and how it is read. */
type OnPreview = (i: number, read: () => Promise<Preview>) => void;

/** The targets and passes of previews of one size. */
class PreviewTargets {
  private readonly gpu: Gpu;
  private readonly uniforms: FrameUniforms;
  private readonly frameRenderer: FrameRenderer;
  private readonly screen = dataTarget(1, UnsignedByteType);
  private readonly exposure = uniform(0);
  private passes: PassCache;
  private lightMeter: LightMeter;
  private size = { width: 1, height: 1 };
  private uploads: readonly SceneUpload[] = [];

  constructor(gpu: Gpu, uniforms: FrameUniforms) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.frameRenderer = new FrameRenderer(gpu, uniforms);
    this.passes = new PassCache(gpu.renderer);
    this.lightMeter = new LightMeter(gpu, this.frameRenderer.buffer, uniforms);
  }

  /** Lets go of the passes of scenes that are gone. */
  prepare({ width, height }: PictureSize, uploads: readonly SceneUpload[]): void {
    for (const upload of this.uploads) if (!uploads.includes(upload)) this.frameRenderer.releaseScene(upload);
    this.uploads = uploads;
    if (width === this.size.width && height === this.size.height) return;
    this.size = { width, height };
    this.frameRenderer.setSize(width, height);
    this.screen.setSize(width, height);
  }

  /** Plans of another shape have other targets, which passes read. */
  setFrameGraph(plan: FrameGraph): void {
    this.passes.dispose();
    this.lightMeter.dispose();
    this.passes = new PassCache(this.gpu.renderer);
    this.lightMeter = new LightMeter(this.gpu, this.frameRenderer.buffer, this.uniforms);
    this.frameRenderer.runnerFor(plan).updateStills(plan);
  }

  draw(
    plan: FrameGraph,
    of: readonly PreviewRequest[],
    { frameSetup, buffers }: RenderContext,
    finished: OnPreview,
  ): void {
    const [first] = buffers;
    const { size } = this;
    const settings = { ...first.settings, frameGraph: plan };
    const sittingOf = (motif: typeof first, i: number): BoundRenderView => ({
      view: { ...motif, settings: bufferSettings(settings, i) },
      bind: () => frameSetup.setView(motif, size),
    });
    const [sitting, ...others] = buffers.map(sittingOf);
    frameSetup.setView(first, size);
    frameSetup.jitter(PIXEL_CENTER, size);
    this.frameRenderer.draw([sitting, ...others], frameSetup.camera, first.viewPoint.t, (step, image) => {
      of.forEach((each, i) => {
        if (each.kind === 'image' && each.step === step) finished(i, this.image(image, each.exposure));
        if (each.kind === 'luminance' && each.step === step)
          finished(i, () => this.luminance(image, first.observation.c));
      });
    });
    of.forEach((each, i) => {
      if (each.kind === 'albedo') finished(i, this.albedo(each.buffer));
    });
  }

  dispose(): void {
    for (const held of [this.frameRenderer, this.passes, this.lightMeter, this.screen]) held.dispose();
  }

  private image({ texture }: RenderTarget, exposure: number | undefined): () => Promise<Preview> {
    const tone = exposure === undefined ? 'linear' : 'neutral';
    this.exposure.value = exposure ?? 0;
    return this.displayed(`${tone} ${texture.id}`, () =>
      Fn(() => vec4(encodeSrgb(toneMaps[tone](texelHere(texture).rgb, this.exposure)), 1))(),
    );
  }

  private albedo(buffer: number): () => Promise<Preview> {
    const { frameRenderer } = this;
    const texel = (name: 'base' | 'object'): Texture => frameRenderer.bufferOf(buffer).texture(name);
    return this.displayed(`albedo ${buffer}`, () =>
      Fn(() => {
        const there = texelHere(texel('object')).x.greaterThan(0.5);
        return select(there, vec4(encodeSrgb(texelHere(texel('base')).rgb), 1), vec4(0));
      })(),
    );
  }

  private displayed(name: string, output: () => Vec4): () => Promise<Preview> {
    this.passes.run(name, output, this.screen);
    return () => readBytes(this.gpu, this.screen, { x: 0, y: 0, ...this.size });
  }

  private async luminance(image: RenderTarget, c: number): Promise<Preview> {
    const { luminance } = await this.lightMeter.measure(image.texture, image.width, image.height, c);
    return luminance;
  }
}
