import type { Scene } from '../scene/types.ts';
import type { LightMeterReadings, MeteredQuantities } from '../scene/view/metering.ts';
import type { PictureViews } from '../scene/view/pictureViews.ts';
import type { AovName, RenderSettings } from '../scene/view/view.ts';
import type { DomeMaps } from './lights/sky/domeMaps.ts';
import type { BesideOptions, PickResult, RendererInfo, Sampling, ShadingChoice } from './settings.ts';

/**
 * The renderer as a page, a command line and a benchmark use it; `SceneRenderer` (renderer.ts) implements it:
 * `const renderer = await SceneRenderer.create({ canvas })`. Pixels have their rows from the top, on every backend.
 */
export interface RasterRenderer {
  /** What draws, and what the last frame cost. */
  readonly info: RendererInfo;
  /** Of the picture [px]. */
  readonly width: number;
  /** Of the picture [px]. */
  readonly height: number;
  /** Of the next pictures; `deferred` at first. */
  shading: ShadingChoice;
  /** Uploads a scene and releases the previous one; the scene is not changed and may be shared. `others`: scenes 1, 2 … of a frame graph's extra G-buffers. */
  setScene(scene: Scene, others?: readonly Scene[]): Promise<void>;
  /** Shows another picture of the dome of a scene (its index; default 0), of the same size, from the next picture on: that of a film. */
  showDome(maps: DomeMaps, scene?: number): void;
  /** Size of the picture in device pixels. */
  setSize(width: number, height: number): void;
  /**
   * Draws one picture of all views, and presents it if there is a canvas. Returns before the GPU has finished. `sampling`: default 1. Draws nothing if `info.waiting`
   * afterwards: samples of motions, or code that few pictures need, are still being loaded; call it again.
   * Throws a RangeError if viewports overlap or extend beyond the picture.
   */
  render(views: PictureViews, settings: RenderSettings, sampling?: Sampling): void;
  /**
   * Adds a sample to the last picture, and presents it if there is a canvas, until the picture has n × n samples, n a power of two. Returns whether
   * samples remain. AOVs, `pick` and `measureLight` keep using the pixels' centres.
   */
  accumulate(n: number): boolean;
  /**
   * Compiles the shaders of a picture and of its accumulation without blocking other frames; undefined if there is nothing to compile ahead. While other shaders are
   * being compiled, returns their promise: call again afterwards. Rejects if the device is lost.
   */
  precompile(views: PictureViews, settings: RenderSettings, sampling?: Sampling): Promise<void> | undefined;
  /** The last picture, sRGB, RGBA8. Resolves when the GPU has finished it. */
  readPixels(): Promise<Uint8Array>;
  /** An AOV of the last picture, with as many values per pixel as it has channels. */
  readAov(name: AovName): Promise<Float32Array>;
  /** Samples the last picture at `METER_CELLS` × `METER_CELLS` positions, for automatic exposure and false-colour scales. `quantities`: default all. */
  measureLight(quantities?: MeteredQuantities): Promise<LightMeterReadings>;
  /** What the last picture shows at a pixel (from the top left); undefined outside its views. */
  pick(x: number, y: number): Promise<PickResult | undefined>;
  /**
   * Makes a further renderer on the same device, without a canvas, with scenes, size, picture, samples and history of its own; neither changes the other's. What they
   * show of the same `Scene` is on the GPU once: vertices, instances and textures. It can be used until this one is disposed of.
   */
  beside(options?: BesideOptions): RasterRenderer;
  /** Gives back all that it holds on the GPU; the device too, unless another renderer made this one `beside` itself. */
  dispose(): void;
}
