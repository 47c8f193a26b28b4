import type { LightMeterReadings } from '../scene/view/metering.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view/view.ts';

/** Of a picture [px]. */
export interface PictureSize {
  readonly width: number;
  readonly height: number;
}

export interface PictureRequest {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  /** n × n samples per pixel. */
  readonly samples: number;
  /** The picture itself is wanted, for a screen. */
  readonly pixels: boolean;
  readonly aovs: readonly AovName[];
}

/** AOVs with their values, as the renderer reads them back: as many values per pixel as there are channels. */
export type AovValues = ReadonlyMap<AovName, Float32Array>;

export interface RenderedPicture {
  /** sRGB, RGBA8, rows from the top; empty where it was not asked for. */
  readonly pixels: Uint8Array;
  readonly aovs: AovValues;
}

/** Makes pictures of one scene, all of one size. */
export interface PictureRenderer {
  /** `onPart` hears, now and then, which part of the picture is done, 0 … 1. */
  render(request: PictureRequest, onPart?: (part: number) => void): Promise<RenderedPicture>;
  /** Of those that measure pictures by themselves, as the page does, and paint `settings.falseColors`; of others it is done with their data. */
  measureLight?(view: ViewPoint, settings: RenderSettings): Promise<LightMeterReadings>;
}
