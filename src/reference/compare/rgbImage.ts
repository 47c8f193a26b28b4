/** A picture to compare: R, G, B of each pixel one after another, rows from the top. What the numbers mean, each metric says. */
export interface RgbImage {
  readonly width: number;
  readonly height: number;
  readonly rgb: Float32Array;
}
