import type { LightMeterReadings } from '../scene/view/metering.ts';
import type { AovName } from '../scene/view/view.ts';
import type { PictureRequest } from './pictureRenderer.ts';

/**
 * The page that the command line drives to render with WebGL2. It renders scenes that the page's server has read, and
 * returns pictures as base64, which remote calls can carry.
 *
 * `await page.goto('…/headless.html')`, `await page.evaluate(() => window.slowlight.start('raster'))`, then
 * `await page.evaluate((r) => window.slowlight.open(r), { scenes: '/scenes', files: '/parts/', width: 640, height: 360 })`
 * once, and `await page.evaluate((r) => window.slowlight.render(r), { views, settings, samples: 1, pixels: true, aovs: ['depth'] })` per picture.
 * Errors reject the call with the renderer's message.
 */
export interface HeadlessPage {
  /** `pipeline`: the id of one that draws frames. */
  start(pipeline: string): Promise<StartReply>;
  open(request: OpenRequest): Promise<void>;
  /** Shows another picture of the dome of a scene; `maps`: the address of encoded `DomeMaps`. */
  showDome(request: { readonly index: number; readonly maps: string }): Promise<void>;
  render(request: PictureRequest): Promise<RenderReply>;
  /** Light meter readings as base64 of little-endian f32. */
  measure(request: Pick<PictureRequest, 'views' | 'settings'>): Promise<Record<keyof LightMeterReadings, string>>;
}

export interface OpenRequest {
  /**
   * Address of the encoded scenes (scene/transfer/transferCodec.ts): the picture's, and those of further G-buffers of
   * its frame graph.
   */
  readonly scenes: string;
  /** Address of file ranges, for samples that were left in files: `from/length/{handle as JSON}`. */
  readonly files: string;
  /** Size of the pictures [px]. */
  readonly width: number;
  readonly height: number;
}

export interface StartReply {
  /** The graphics adapter, as the browser names it. */
  readonly adapterName: string;
  /** Maximum pixels per side. */
  readonly largest: number;
}

export interface RenderReply {
  /** Base64 of RGBA8, sRGB, rows from the top; empty if not requested. */
  readonly pixels: string;
  /** Base64 of little-endian f32 in the AOV's channels, rows from the top. */
  readonly aovs: Readonly<Partial<Record<AovName, string>>>;
}
