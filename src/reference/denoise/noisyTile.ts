import type { ImageTile } from '../tileRequest.ts';

/** A part of a picture to be denoised. */
export interface NoisyTile {
  /** What is given: the tile, and what lies around it. */
  readonly window: ImageTile;
  /** The layer `denoiser_input`: linear radiance, albedo 0 … 1, and normal, of length 0 without a surface; 9 values per pixel, rows from the top. */
  readonly values: Float32Array;
  /** Exposes the radiance for the network. */
  readonly gain: number;
}
