import type { ImageTile } from '../tileRequest.ts';

/** A part of a picture to be denoised: 3 values per pixel, rows from the top. */
export interface NoisyTile {
  /** What is given: the tile, and what lies around it. */
  readonly window: ImageTile;
  /** Linear radiance. */
  readonly beauty: Float32Array;
  /** 0 … 1 */
  readonly albedo: Float32Array;
  /** Of length 1, or 0 without a surface. */
  readonly normal: Float32Array;
  /** Exposes the radiance for the network. */
  readonly gain: number;
}
