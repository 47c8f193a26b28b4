import type { AovName, RenderSettings, ViewPoint } from '../scene/view/view.ts';
import type { LightOptions } from './lights/lightOptions.ts';

/** AOVs, and `picture`: the beauty exposed and tone mapped, linear sRGB 0 … 1 (`encodeDisplay` encodes it). */
export type OutputLayer = AovName | 'picture';

/** The description of a picture to render. */
export interface TileRequest {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  /** Size of the whole picture [px]. */
  readonly width: number;
  readonly height: number;
  readonly layers: readonly OutputLayer[];
  /** n, for n × n samples per pixel of `beauty` and `picture`. */
  readonly samples: number;
  readonly seed: number;
  readonly light: LightOptions;
}

/** Pixels x0 ≤ x < x1, y0 ≤ y < y1, from the top left. */
export interface ImageTile {
  readonly x0: number;
  readonly y0: number;
  readonly x1: number;
  readonly y1: number;
}

/** The requested layers: as many values per pixel as the layer has channels, rows from the top. */
export type TileData = Partial<Record<OutputLayer, Float32Array>>;
