import type { RenderTarget } from 'three/webgpu';
import { type LightMeterReadings, type MeteredQuantities, readingsInPicture } from '../scene/view/metering.ts';
import type { PixelRect } from '../scene/view/pictureViews.ts';
import type { AovName, RenderSettings } from '../scene/view/view.ts';
import type { Capture } from './capture/capture.ts';
import { FrameRenderer } from './frameRenderer.ts';
import { type FrameSetup, frustumIn, type ViewBuffers } from './frameSetup.ts';
import { pickedPixel, readBytes, readData, readFloats } from './gbuffer/readback.ts';
import type { Observation } from './geometry/observation.ts';
import type { Gpu } from './gpu/device.ts';
import type { PictureParts } from './pictureParts.ts';
import type { AntialiasingMode } from './post/resolve/antialiasing.ts';
import { gridPositions, haltonPosition, PIXEL_CENTER, type SamplePosition } from './post/resolve/pixelSamples.ts';
import type { SceneUpload } from './sceneUpload.ts';
import type { PickResult, Sampling, Shading } from './settings.ts';

/** From this sample count on, the mean of the samples beats FXAA. */
const MIN_MEAN_SAMPLES = 8;

/** Draws one view of a picture: its targets, of the size of its viewport, its samples and its history. */
export class ViewRenderer {
  private readonly gpu: Gpu;
  private readonly frameSetup: FrameSetup;
  private readonly frameRenderer: FrameRenderer;
  private readonly parts: PictureParts;
  private rect: PixelRect = { x: 0, y: 0, width: 1, height: 1 };
  /** The G-buffers of the last picture; undefined if it cannot be drawn again. */
  private lastBuffers: ViewBuffers | undefined;
  private lastObservation: Observation | undefined;
  private samplePosition: SamplePosition = PIXEL_CENTER;
  /** Of the last picture, and of the last sample. */
  private pictureShading: Shading = 'deferred';
  private sampleShading: Shading = 'deferred';
  /** Samples that `accumulate` has added to the last picture. */
  private addedSamples = 0;
  private frameCount = 0;

  constructor(gpu: Gpu, frameSetup: FrameSetup, parts: PictureParts) {
    this.gpu = gpu;
    this.parts = parts;
    this.frameSetup = frameSetup;
    this.frameRenderer = new FrameRenderer(gpu, frameSetup.uniforms, parts);
  }

  get viewport(): PixelRect {
    return this.rect;
  }

  get shading(): Shading {
    return this.pictureShading;
  }

  get hasPicture(): boolean {
    return this.lastObservation !== undefined;
  }

  /** Whether it has drawn a picture of this scene. */
  get hasScenePicture(): boolean {
    return this.lastBuffers !== undefined;
  }

  /** The capture of one of its G-buffers. */
  capture(buffer: number): Capture {
    return this.frameRenderer.capture(buffer);
  }

  setViewport(rect: PixelRect): void {
    const { width, height } = this.rect;
    this.rect = rect;
    if (rect.width !== width || rect.height !== height) this.frameRenderer.setSize(rect.width, rect.height);
  }

  /** As `FrameSetup.prepare`, for a picture in `rect`. */
  prepare(buffers: ViewBuffers, rect: PixelRect, ready?: () => void): readonly boolean[] | undefined {
    const { frameSetup, frameRenderer } = this;
    const { settings } = buffers[0];
    this.setDisplay(buffers);
    const visible = frameSetup.prepare(buffers, rect, ready);
    if (visible && settings.frameGraph) frameRenderer.runnerFor(settings.frameGraph).updateStills(settings.frameGraph);
    return visible;
  }

  /** Draws buffers that `prepare` has prepared. */
  draw(buffers: ViewBuffers, mode: AntialiasingMode, sampling: Sampling, shading: Shading): void {
    this.lastBuffers = buffers;
    this.pictureShading = shading;
    this.frameRenderer.trimCaptures(buffers.map(({ capture }) => capture !== undefined));
    this.addedSamples = 0;
    if (mode === 'temporal') this.drawTemporal(buffers);
    else this.drawSamples(buffers, mode === 'mean' ? Number(sampling) : 1);
    this.lastObservation = buffers[0].observation;
  }

  /** Runs all passes of a picture and of its accumulation in drawing order, so that `precompile` finds their shaders. */
  traversePasses(buffers: ViewBuffers, mode: AntialiasingMode, target: 'canvas' | 'screen', shading: Shading): void {
    this.drawBuffers(buffers, PIXEL_CENTER, shading);
    // Nothing has been drawn.
    this.frameRenderer.resetCaptures();
    this.frameRenderer.runDisplayPasses(mode, buffers[0].projection, target);
  }

  /** Adds a sample if any remains; `more`: whether others remain. See `RasterRenderer.accumulate`. */
  accumulate(n: number): { readonly added: boolean; readonly more: boolean } {
    const { frameRenderer, addedSamples } = this;
    const count = n * n;
    if (
      addedSamples === count ||
      frameRenderer.samples > 1 ||
      !this.lastBuffers ||
      !canAccumulate(this.lastBuffers[0].settings)
    )
      return { added: false, more: false };
    const buffers = this.restore();
    if (!buffers) return { added: false, more: true };
    this.drawSample(buffers, gridPositions(n)[addedSamples], 1 / n);
    this.addedSamples = addedSamples + 1;
    const isShown = this.addedSamples >= Math.min(MIN_MEAN_SAMPLES, count);
    frameRenderer.antialiasing.addSample(addedSamples, count, frameRenderer.displayState, isShown);
    return { added: true, more: this.addedSamples < count };
  }

  /** Presents the picture on the canvas, which has no other view. */
  presentOnCanvas(): void {
    this.frameRenderer.present('canvas');
  }

  /** Presents the picture in a target of its own. */
  present(): RenderTarget {
    this.bind();
    return this.frameRenderer.present('screen');
  }

  readPixels(): Promise<Uint8Array> {
    return readBytes(this.gpu, this.present(), this.wholeRegion());
  }

  async readAov(name: AovName): Promise<Float32Array> {
    if (name === 'sample_count') throw new Error(`the rasterizer has no ${name}`);
    this.drawPixelCenters();
    this.bind();
    if (name !== 'beauty')
      return readData(this.gpu, this.frameRenderer, name, this.requireObservation(), this.wholeRegion());
    const { target, index } = this.frameRenderer.beauty();
    return withoutAlpha(await readFloats(this.gpu, target, index, this.wholeRegion()));
  }

  /** What a pixel shows. `upload`: that of the first G-buffer; x and y from the viewport's top left. */
  async pick(upload: SceneUpload, x: number, y: number): Promise<PickResult> {
    this.drawPixelCenters();
    const pathOf = (id: number) => upload.bodies[id - 1].object.path;
    const observation = this.requireObservation();
    return pickedPixel(await this.frameRenderer.readPixel(x, y), observation, pathOf);
  }

  async measureLight(quantities: MeteredQuantities): Promise<LightMeterReadings> {
    this.drawPixelCenters(quantities === 'luminance' ? this.sampleShading : 'deferred');
    this.bind();
    const lens = this.lastBuffers?.[0].viewPoint.lens;
    const readings = await this.frameRenderer.measureLight(this.requireObservation().c, quantities);
    return lens ? readingsInPicture(readings, lens, this.rect) : readings;
  }

  /** Prepares the last picture again if another view has been prepared since; undefined if it cannot be drawn again. */
  restore(): ViewBuffers | undefined {
    const { lastBuffers, frameSetup } = this;
    if (!lastBuffers) return undefined;
    return frameSetup.isPrepared(lastBuffers) || this.prepare(lastBuffers, this.rect) ? lastBuffers : undefined;
  }

  /** Sets the uniforms, the camera and the display state to those of the last sample. */
  private bind(): void {
    const { frameSetup, lastBuffers } = this;
    if (!lastBuffers) return;
    this.setDisplay(lastBuffers);
    frameSetup.setSample(lastBuffers[0], this.samplePosition, this.rect);
  }

  /** Releases the passes that read a scene; the last picture cannot be drawn again until `keep`. */
  releaseScene(upload: SceneUpload): void {
    this.lastBuffers = undefined;
    this.frameRenderer.releaseScene(upload);
  }

  /** Lets the last picture be drawn again: the uploads of these buffers have not been released. */
  keep(buffers: ViewBuffers): void {
    this.lastBuffers = buffers;
  }

  dispose(): void {
    this.frameRenderer.dispose();
  }

  private setDisplay({ 0: { settings, upload }, length }: ViewBuffers): void {
    const { frameRenderer } = this;
    const overlay = this.parts.overlayOf(settings, frameRenderer.buffer, () => frameRenderer.bufferOf(length - 1));
    frameRenderer.displayState = {
      ...settings,
      ...(overlay && { overlay }),
      hasStars: upload.stars !== undefined,
      hasUnlit: upload.hasUnlit && !settings.frameGraph,
    };
  }

  /** Draws n × n samples per pixel. */
  private drawSamples(buffers: ViewBuffers, n: number): void {
    const { frameRenderer } = this;
    frameRenderer.samples = n * n;
    for (const [i, position] of gridPositions(n).entries()) {
      this.drawSample(buffers, position, 1 / n);
      if (n > 1) frameRenderer.antialiasing.addSample(i, n * n, frameRenderer.displayState, true);
    }
    if (frameRenderer.displayState.falseColors) this.drawPixelCenters();
    else if (n === 1) frameRenderer.antialiasing.resolveSingle(frameRenderer.displayState);
  }

  /** Draws one sample and blends it with the history. */
  private drawTemporal(buffers: ViewBuffers): void {
    const { frameRenderer } = this;
    const [{ observation, viewPoint, projection }] = buffers;
    frameRenderer.samples = 1;
    this.drawSample(buffers, haltonPosition(this.frameCount++));
    const frustum = frustumIn(this.rect, viewPoint);
    const state = { observation, viewPoint, projection, frustum };
    frameRenderer.antialiasing.resolveTemporal(frameRenderer.displayState, state);
  }

  /** `footprint`: as the uniform. */
  private drawSample(
    buffers: ViewBuffers,
    position: SamplePosition,
    footprint = 1,
    shading: Shading = this.pictureShading,
  ): void {
    const { uniforms } = this.frameSetup;
    uniforms.footprint.value = footprint;
    this.drawBuffers(buffers, position, shading);
    uniforms.footprint.value = 1;
    this.samplePosition = position;
    this.sampleShading = shading;
  }

  /** Draws the prepared buffers, sampled at one position within each pixel. */
  private drawBuffers(buffers: ViewBuffers, position: SamplePosition, shading: Shading): void {
    const sample = this.frameSetup.sample(buffers, position, this.rect, this.parts);
    if (shading === 'forward') this.frameRenderer.drawForward(sample);
    else this.frameRenderer.draw(sample);
  }

  /** Draws the last picture at the pixels' centres, by default with its G-buffer: data that is read back is never averaged. */
  private drawPixelCenters(shading: Shading = 'deferred'): void {
    const [x, y] = this.samplePosition;
    const isDrawn = x === 0 && y === 0 && this.sampleShading === shading;
    const buffers = isDrawn ? undefined : this.restore();
    if (buffers) this.drawSample(buffers, PIXEL_CENTER, 1, shading);
  }

  private requireObservation(): Observation {
    if (!this.lastObservation) throw new Error('nothing has been rendered yet');
    return this.lastObservation;
  }

  private wholeRegion(): PixelRect {
    const { width, height } = this.rect;
    return { x: 0, y: 0, width, height };
  }
}

/** Whether pictures at rest accumulate samples. False colours never do, because they stand for numbers. */
export const canAccumulate = ({ antialiasing, falseColors }: RenderSettings): boolean => antialiasing && !falseColors;

function withoutAlpha(rgba: Float32Array): Float32Array {
  const out = new Float32Array((rgba.length / 4) * 3);
  for (let i = 0; i < rgba.length / 4; i++) for (let k = 0; k < 3; k++) out[3 * i + k] = rgba[4 * i + k];
  return out;
}
