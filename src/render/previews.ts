import { Fn, select, uniform, vec4 } from 'three/tsl';
import { type RenderTarget, type Texture, UnsignedByteType } from 'three/webgpu';
import { type FrameGraph, frameGraphStructure } from '../scene/frameGraph/frameGraph.ts';
import type { PictureSize } from '../scene/view/pictureSize.ts';
import { bufferSettings } from '../scene/view/view.ts';
import { toneMaps } from '../shaders/color/toneMap.ts';
import type { Vec4 } from '../shaders/types.ts';
import { FrameRenderer } from './frameRenderer.ts';
import type { ViewBuffers } from './frameSetup.ts';
import { dataTarget } from './gbuffer/gbuffer.ts';
import { readBytes } from './gbuffer/readback.ts';
import type { Gpu } from './gpu/device.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import { texelHere } from './gpu/fullScreenPass.ts';
import { PassCache } from './gpu/passCache.ts';
import { precompile } from './gpu/precompile.ts';
import type { PictureParts } from './pictureParts.ts';
import { encodeSrgb } from './post/display/display.ts';
import { LightMeter } from './post/display/lightMeter.ts';
import { PIXEL_CENTER } from './post/resolve/pixelSamples.ts';
import type { RenderContext, SceneRenderer } from './renderer.ts';
import type { SceneUpload } from './sceneUpload.ts';

/** What a preview shows of a frame graph. */
export type PreviewRequest =
  /** The image of a pass. `exposure` [EV]: for linear light before tone mapping; absent: the image is 0 … 1 already. */
  | { readonly kind: 'image'; readonly step: number; readonly exposure?: number }
  /** The luminance of a pass's image, sampled as by the light meter. */
  | { readonly kind: 'luminance'; readonly step: number }
  /** The albedo of a G-buffer; transparent where there is no surface. */
  | { readonly kind: 'albedo'; readonly buffer: number };

/** Rows from the top: sRGB, RGBA8; or luminances. */
export type Preview = Uint8Array | Float32Array;

/**
 * Draws small pictures of the passes of a frame graph, into targets of its own, from the scenes as they are prepared for the displayed picture. Does not
 * change that picture, its samples or its history.
 */
export class PreviewRenderer {
  private readonly renderer: SceneRenderer;
  private targets: PreviewTargets | undefined;
  /** Identifies the shaders that are compiled. */
  private compiledKey = '';

  constructor(renderer: SceneRenderer) {
    this.renderer = renderer;
  }

  /**
   * Returns the previews in the order of `requests`; undefined if there is no picture. `frameGraph`: its G-buffers are those of the displayed picture, in
   * the same order. Shaders are compiled without blocking other frames. Do not call it again before it has resolved.
   */
  async make(
    frameGraph: FrameGraph,
    requests: readonly PreviewRequest[],
    size: PictureSize,
  ): Promise<readonly Preview[] | undefined> {
    await this.renderer.loadFrameGraphs();
    await this.renderer.withLastView((context) =>
      this.precompiled(frameGraph, requests, this.targetsFor(context, size), context),
    );
    const previews = this.renderer.withLastView((context) => {
      const promises: Promise<Preview>[] = [];
      this.targetsFor(context, size).draw(frameGraph, requests, context, (i, read) => {
        promises[i] = read();
      });
      return promises;
    });
    return previews && Promise.all(previews);
  }

  dispose(): void {
    this.targets?.dispose();
  }

  private targetsFor({ gpu, frameSetup, parts, buffers }: RenderContext, size: PictureSize): PreviewTargets {
    this.targets ??= new PreviewTargets(gpu, frameSetup.uniforms, parts);
    this.targets.prepare(
      size,
      buffers.map(({ upload }) => upload),
    );
    return this.targets;
  }

  private precompiled(
    frameGraph: FrameGraph,
    requests: readonly PreviewRequest[],
    targets: PreviewTargets,
    context: RenderContext,
  ): Promise<void> | undefined {
    const shaders = [frameGraphStructure(frameGraph), ...context.buffers.map(({ upload }) => upload.serial)].join(' ');
    if (shaders === this.compiledKey) return undefined;
    this.compiledKey = shaders;
    targets.setFrameGraph(frameGraph);
    return precompile(context.gpu.renderer, () => targets.draw(frameGraph, requests, context, () => {}));
  }
}

/** Called when request `i` has been drawn, with the function that reads it back. */
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

  constructor(gpu: Gpu, uniforms: FrameUniforms, parts: PictureParts) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.frameRenderer = new FrameRenderer(gpu, uniforms, parts);
    this.passes = new PassCache(gpu.renderer);
    this.lightMeter = new LightMeter(gpu, this.frameRenderer.buffer, uniforms);
  }

  /** Sets the size, and releases the passes of scenes that are no longer used. */
  prepare({ width, height }: PictureSize, uploads: readonly SceneUpload[]): void {
    for (const upload of this.uploads) if (!uploads.includes(upload)) this.frameRenderer.releaseScene(upload);
    this.uploads = uploads;
    if (width === this.size.width && height === this.size.height) return;
    this.size = { width, height };
    this.frameRenderer.setSize(width, height);
    this.screen.setSize(width, height);
  }

  /** Call it when the structure of the frame graph changes: the passes here read its targets. */
  setFrameGraph(frameGraph: FrameGraph): void {
    this.passes.dispose();
    this.lightMeter.dispose();
    this.passes = new PassCache(this.gpu.renderer);
    this.lightMeter = new LightMeter(this.gpu, this.frameRenderer.buffer, this.uniforms);
    this.frameRenderer.runnerFor(frameGraph).updateStills(frameGraph);
  }

  draw(
    frameGraph: FrameGraph,
    requests: readonly PreviewRequest[],
    { frameSetup, parts, buffers }: RenderContext,
    onPreview: OnPreview,
  ): void {
    const [first] = buffers;
    const { size } = this;
    const settings = { ...first.settings, frameGraph };
    const shown = ([first, ...others]: ViewBuffers): ViewBuffers => [
      { ...first, settings },
      ...others.map((view, i) => ({ ...view, settings: bufferSettings(settings, i + 1) })),
    ];
    const sample = frameSetup.sample(shown(buffers), PIXEL_CENTER, size, parts);
    this.frameRenderer.draw(sample, (pass, image) => {
      requests.forEach((request, i) => {
        if (request.kind === 'image' && request.step === pass) onPreview(i, this.image(image, request.exposure));
        if (request.kind === 'luminance' && request.step === pass)
          onPreview(i, () => this.luminance(image, first.observation.c));
      });
    });
    requests.forEach((request, i) => {
      if (request.kind === 'albedo') onPreview(i, this.albedo(request.buffer));
    });
  }

  dispose(): void {
    for (const owned of [this.frameRenderer, this.passes, this.lightMeter, this.screen]) owned.dispose();
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
        const hasSurface = texelHere(texel('object')).x.greaterThan(0.5);
        return select(hasSurface, vec4(encodeSrgb(texelHere(texel('base')).rgb), 1), vec4(0));
      })(),
    );
  }

  private displayed(name: string, output: () => Vec4): () => Promise<Preview> {
    this.passes.run(name, output, this.screen);
    return () => readBytes(this.gpu, this.screen, { x: 0, y: 0, ...this.size });
  }

  private async luminance(image: RenderTarget, c: number): Promise<Preview> {
    const { luminance } = await this.lightMeter.measure(image.texture, image, c, 'luminance');
    return luminance;
  }
}
