import type { Gauge } from '../../scene/gauge.ts';
import type { AovName, RenderSettings, ViewPoint } from '../../scene/view.ts';

/** Of a picture [px]. */
export interface Size {
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
export type AovData = ReadonlyMap<AovName, Float32Array>;

export interface Painted {
  /** sRGB, RGBA8, rows from the top; empty where it was not asked for. */
  readonly pixels: Uint8Array;
  readonly aovs: AovData;
}

/** Makes pictures of one scene, all of one size: on a GPU, in a browser, or on the processor. */
export interface PicturePainter {
  /** n × n samples per pixel where nobody says. */
  readonly usualSamples: number;
  /** `onPart` hears, now and then, which part of the picture is done, 0 … 1. */
  paint(request: PictureRequest, onPart?: (part: number) => void): Promise<Painted>;
  /** Of those that measure pictures by themselves, as the page does, and paint `settings.falseColors`; of others it is done with their data. */
  measure?(view: ViewPoint, settings: RenderSettings): Promise<Gauge>;
}
