import type { AovName, RenderSettings, ViewPoint } from '../scene/view/view.ts';
import type { LightOptions } from './lights/lightOptions.ts';
import type { AdaptiveSampling } from './sampling/adaptiveSampling.ts';

/**
 * AOVs; `picture`: the beauty exposed and tone mapped, linear sRGB 0 … 1 (`encodeDisplay` encodes it); `denoiser_input`: light, albedo and normal, means
 * over a pixel's samples, the light without fireflies if the picture is requested, too.
 */
export type OutputLayer = AovName | 'picture' | 'denoiser_input';

/** The description of a picture to render. */
export interface TileRequest {
  /** The observer's event, velocity and camera. */
  readonly view: ViewPoint;
  /** Settings of the picture; some belong to the rasterizer only. */
  readonly settings: RenderSettings;
  /** Width of the whole picture [px]. */
  readonly width: number;
  /** Height of the whole picture [px]. */
  readonly height: number;
  /** What to compute. */
  readonly layers: readonly OutputLayer[];
  /** n, for n × n samples per pixel of `beauty` and `picture`; at most that many with adaptive sampling. */
  readonly samples: number;
  /** Fewer samples where there is little noise. Absent: every pixel has n × n. */
  readonly adaptive?: AdaptiveSampling;
  /** The same seed gives the same noise. */
  readonly seed: number;
  /** How light is followed. */
  readonly light: LightOptions;
}

/** Pixels x0 ≤ x < x1, y0 ≤ y < y1, from the top left. */
export interface ImageTile {
  /** Left edge [px]. */
  readonly x0: number;
  /** Top edge [px]. */
  readonly y0: number;
  /** After the right edge [px]. */
  readonly x1: number;
  /** After the bottom edge [px]. */
  readonly y1: number;
}

/** The requested layers: as many values per pixel as the layer has channels, rows from the top. */
export type TileData = Partial<Record<OutputLayer, Float32Array>>;
