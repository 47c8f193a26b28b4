/** A picture to compare: interleaved R, G, B, rows from the top. Each metric defines the meaning of the values. */
export interface RgbImage {
  readonly width: number;
  readonly height: number;
  readonly rgb: Float32Array;
}
