/** 2r + 1 weights, for the offsets −r … r. */
export type ConvolutionKernel = Float64Array;

/** Σₖ kernel[k] · plane(x + k − r, y), with the border pixels repeated outside. */
export function alongRows(plane: Float32Array, width: number, height: number, kernel: ConvolutionKernel): Float32Array {
  const radius = kernel.length >> 1;
  const out = new Float32Array(plane.length);
  const row = new Float64Array(width + 2 * radius);
  for (let y = 0; y < height; y++) {
    const start = y * width;
    for (let i = 0; i < row.length; i++) row[i] = plane[start + Math.min(Math.max(i - radius, 0), width - 1)];
    for (let x = 0; x < width; x++) {
      let sum = 0;
      for (let k = 0; k < kernel.length; k++) sum += kernel[k] * row[x + k];
      out[start + x] = sum;
    }
  }
  return out;
}

/** The same along columns. */
export function alongColumns(
  plane: Float32Array,
  width: number,
  height: number,
  kernel: ConvolutionKernel,
): Float32Array {
  const radius = kernel.length >> 1;
  const out = new Float32Array(plane.length);
  const sums = new Float64Array(width);
  for (let y = 0; y < height; y++) {
    sums.fill(0);
    for (let k = 0; k < kernel.length; k++) {
      const weight = kernel[k];
      const start = Math.min(Math.max(y + k - radius, 0), height - 1) * width;
      for (let x = 0; x < width; x++) sums[x] += weight * plane[start + x];
    }
    out.set(sums, y * width);
  }
  return out;
}

/** f at −r … r, scaled so that the positive weights sum to 1 and the negative ones, if any, to −1. */
export function kernelOf(radius: number, f: (x: number) => number): ConvolutionKernel {
  const values = Float64Array.from({ length: 2 * radius + 1 }, (_, i) => f(i - radius));
  const total = (sign: number) => values.reduce((sum, value) => sum + Math.max(sign * value, 0), 0);
  const [positive, negative] = [total(1), total(-1)];
  return values.map((value) => (value > 0 ? value / positive : value < 0 ? value / negative : 0));
}
