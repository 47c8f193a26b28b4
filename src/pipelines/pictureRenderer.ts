import type { LightMeterReadings } from '../scene/view/metering.ts';
import type { PictureViews } from '../scene/view/pictureViews.ts';
import type { AovName, RenderSettings } from '../scene/view/view.ts';

export interface PictureRequest {
  readonly views: PictureViews;
  readonly settings: RenderSettings;
  /** n × n samples per pixel. */
  readonly samples: number;
  /** Whether to return the display picture. */
  readonly pixels: boolean;
  readonly aovs: readonly AovName[];
}

/** Values of AOVs as the renderer reads them back, with as many values per pixel as there are channels. */
export type AovValues = ReadonlyMap<AovName, Float32Array>;

export interface RenderedPicture {
  /** sRGB, RGBA8, rows from the top; empty if not requested. */
  readonly pixels: Uint8Array;
  readonly aovs: AovValues;
}

/** Renders pictures of one scene, all of one size. */
export interface PictureRenderer {
  /** `onPart` gets the completed fraction of the picture, 0 … 1. */
  render(request: PictureRequest, onPart?: (part: number) => void): Promise<RenderedPicture>;
  /**
   * For renderers that measure luminance themselves, as the page does, and draw `settings.falseColors`; for others it
   * is computed from their data.
   */
  measureLight?(views: PictureViews, settings: RenderSettings): Promise<LightMeterReadings>;
}
