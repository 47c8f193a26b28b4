import type { Scene } from '../scene/types.ts';
import type { LightMeterReadings } from '../scene/view/metering.ts';
import type { PictureViews } from '../scene/view/pictureViews.ts';
import type { AovName, RenderSettings } from '../scene/view/view.ts';
import type { PickResult, RendererInfo, Sampling } from './settings.ts';

/**
 * The renderer as a page, a command line and a benchmark use it; `SceneRenderer` (renderer.ts) implements it:
 * `const renderer = await SceneRenderer.create({ canvas })`. Pixels have their rows from the top, on every backend.
 */
export interface RasterRenderer {
  readonly info: RendererInfo;
  readonly width: number;
  readonly height: number;
  /** Uploads a scene in place of the one before; the scene is not changed and may be shared. `others`: scenes 1, 2 … of a frame graph's further G-buffers. */
  setScene(scene: Scene, others?: readonly Scene[]): Promise<void>;
  /** Size of the picture in device pixels. */
  setSize(width: number, height: number): void;
  /**
   * Draws one picture of all views, and presents it if there is a canvas. Synchronous: the GPU may still be at work when it returns. `sampling`: default 1.
   * Throws a RangeError where viewports leave the picture or overlap.
   */
  render(views: PictureViews, settings: RenderSettings, sampling?: Sampling): void;
  /**
   * Adds a sample to the last picture, and presents it if there is a canvas; in the end it is the picture of n × n samples, n a power of two. Returns
   * whether there are more to add. Data and light are those of the pixels' centres all the while.
   */
  accumulate(n: number): boolean;
  /**
   * Compiles, between the frames of others, the shaders of a picture that would be the first of its kind, and of its refinement; undefined if it can be
   * drawn at once. While something else is being compiled, the promise is of that: ask again afterwards. Rejects where the device is lost.
   */
  precompile(views: PictureViews, settings: RenderSettings, sampling?: Sampling): Promise<void> | undefined;
  /** The last picture, sRGB, RGBA8. Also the way to wait for the GPU. */
  readPixels(): Promise<Uint8Array>;
  /** Of the last picture; as many values per pixel as the AOV has channels. */
  readAov(name: AovName): Promise<Float32Array>;
  /** The last picture at `METER_CELLS` × `METER_CELLS` places: automatic exposure and false-colour scales are computed from it. */
  measureLight(): Promise<LightMeterReadings>;
  /** What is at a pixel of the last picture (from the top left); undefined outside of its views. */
  pick(x: number, y: number): Promise<PickResult | undefined>;
  dispose(): void;
}
