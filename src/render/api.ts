import type { Scene } from '../scene/types.ts';
import type { LightMeterReadings } from '../scene/view/metering.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view/view.ts';
import type { PickResult, RendererInfo, Sampling } from './settings.ts';

/**
 * What a page, a command line and a benchmark may ask of the renderer; `SceneRenderer` (renderer.ts) is the one that does it:
 * `const renderer = await SceneRenderer.create({ canvas })`. Pixels have their rows from the top, on every backend.
 */
export interface RasterRenderer {
  readonly info: RendererInfo;
  readonly width: number;
  readonly height: number;
  /** Uploads a scene in place of the one before; the scene is not changed and may be shared. `others`: what a plan's other G-buffers may be of, 1, 2 … */
  setScene(scene: Scene, others?: readonly Scene[]): Promise<void>;
  /** Size of the picture in device pixels. */
  setSize(width: number, height: number): void;
  /** Makes one picture, and shows it where there is a canvas. Synchronous: the GPU may still be at work when it returns. `sampling`: 1 where nobody says. */
  render(viewPoint: ViewPoint, settings: RenderSettings, sampling?: Sampling): void;
  /**
   * Adds a sample to the last picture, and shows it where there is a canvas; in the end it is that of n × n, a power of two. Tells whether there is more to add.
   * Data are of the pixels' centres all the while, and so is the light.
   */
  accumulate(n: number): boolean;
  /**
   * Compiles, between the frames of others, the shaders of a picture that would be the first of its kind, and of its refinement; undefined: it can be made at once.
   * While something else is being compiled: its end, after which is to be asked again. Rejects where the device is lost.
   */
  precompile(viewPoint: ViewPoint, settings: RenderSettings, sampling?: Sampling): Promise<void> | undefined;
  /** The last picture, sRGB, RGBA8. Also the way to wait for the GPU. */
  readPixels(): Promise<Uint8Array>;
  /** Of the last picture; as many values per pixel as the AOV has channels. */
  readAov(name: AovName): Promise<Float32Array>;
  /** The last picture at `METER_CELLS` × `METER_CELLS` places: what exposure and scales of false colours go by. */
  measureLight(): Promise<LightMeterReadings>;
  /** What is at a pixel of the last picture (from the top left); undefined outside of it. */
  pick(x: number, y: number): Promise<PickResult | undefined>;
  dispose(): void;
}
