import type { Tensor } from './tza.ts';

/** Channels of an image, each with a border of zeros one pixel wide. */
export interface FeatureMap {
  readonly width: number;
  readonly height: number;
  readonly channels: readonly Float32Array[];
}

export const emptyChannel = (width: number, height: number): Float32Array =>
  new Float32Array((width + 2) * (height + 2));

export interface ConvolutionLayer {
  /** Output channels, input channels, 3, 3. */
  readonly weight: Tensor;
  readonly bias: Tensor;
}

/** Output channels that are computed at a time, so that an input value is loaded once for all. */
const AT_A_TIME = 4;

/** max(0, W ∗ x + b): a convolution by 3 × 3 with zeros around the image, and a rectified linear unit. */
export function convolve({ width, height, channels }: FeatureMap, { weight, bias }: ConvolutionLayer): FeatureMap {
  const [count, inputs] = weight.dims as readonly [number, number];
  if (inputs !== channels.length) throw new Error(`${channels.length} channels for ${inputs} of a layer`);
  const padded = AT_A_TIME * Math.ceil(count / AT_A_TIME);
  const out = Array.from({ length: padded }, () => emptyChannel(width, height));
  const weights = new Float64Array(9 * AT_A_TIME);
  for (let o = 0; o < count; o += AT_A_TIME) {
    const group = out.slice(o, o + AT_A_TIME) as Four;
    for (let i = 0; i < inputs; i++) {
      weights.fill(0);
      for (let k = 0; k < Math.min(AT_A_TIME, count - o); k++)
        for (let j = 0; j < 9; j++) weights[9 * k + j] = weight.values[((o + k) * inputs + i) * 9 + j]!;
      accumulate(group, channels[i]!, weights, width, height);
    }
  }
  for (let o = 0; o < count; o++) rectify(out[o]!, bias.values[o]!, width, height);
  return { width, height, channels: out.slice(0, count) };
}

type Four = [Float32Array, Float32Array, Float32Array, Float32Array];

/** Adds one input channel's part of four output channels. */
function accumulate([A, B, C, D]: Four, input: Float32Array, w: Float64Array, width: number, height: number): void {
  const row = width + 2;
  const [a0, a1, a2, a3, a4, a5, a6, a7, a8] = w as unknown as readonly number[];
  const [b0, b1, b2, b3, b4, b5, b6, b7, b8] = w.subarray(9) as unknown as readonly number[];
  const [c0, c1, c2, c3, c4, c5, c6, c7, c8] = w.subarray(18) as unknown as readonly number[];
  const [d0, d1, d2, d3, d4, d5, d6, d7, d8] = w.subarray(27) as unknown as readonly number[];
  for (let y = 0; y < height; y++) {
    let above = y * row;
    let [x0, x1, x3, x4, x6, x7] = [
      input[above]!,
      input[above + 1]!,
      input[above + row]!,
      input[above + row + 1]!,
      input[above + 2 * row]!,
      input[above + 2 * row + 1]!,
    ];
    for (let x = 0; x < width; x++, above++) {
      const at = above + row + 1;
      const x2 = input[above + 2]!;
      const x5 = input[at + 1]!;
      const x8 = input[at + row + 1]!;
      A[at]! += a0! * x0 + a1! * x1 + a2! * x2 + a3! * x3 + a4! * x4 + a5! * x5 + a6! * x6 + a7! * x7 + a8! * x8;
      B[at]! += b0! * x0 + b1! * x1 + b2! * x2 + b3! * x3 + b4! * x4 + b5! * x5 + b6! * x6 + b7! * x7 + b8! * x8;
      C[at]! += c0! * x0 + c1! * x1 + c2! * x2 + c3! * x3 + c4! * x4 + c5! * x5 + c6! * x6 + c7! * x7 + c8! * x8;
      D[at]! += d0! * x0 + d1! * x1 + d2! * x2 + d3! * x3 + d4! * x4 + d5! * x5 + d6! * x6 + d7! * x7 + d8! * x8;
      x0 = x1;
      x1 = x2;
      x3 = x4;
      x4 = x5;
      x6 = x7;
      x7 = x8;
    }
  }
}

function rectify(channel: Float32Array, bias: number, width: number, height: number): void {
  for (let y = 1; y <= height; y++) {
    const row = y * (width + 2);
    for (let i = row + 1; i <= row + width; i++) channel[i] = Math.max(channel[i]! + bias, 0);
  }
}

/** The largest of each 2 × 2 values; width and height are even. */
export function maxPool({ width, height, channels }: FeatureMap): FeatureMap {
  const [w, h, row] = [width / 2, height / 2, width + 2];
  const pooled = channels.map((channel) => {
    const out = emptyChannel(w, h);
    for (let y = 0; y < h; y++)
      for (let x = 0; x < w; x++) {
        const i = (2 * y + 1) * row + 2 * x + 1;
        out[(y + 1) * (w + 2) + x + 1] = Math.max(
          channel[i]!,
          channel[i + 1]!,
          channel[i + row]!,
          channel[i + row + 1]!,
        );
      }
    return out;
  });
  return { width: w, height: h, channels: pooled };
}

/** Each value four times. */
export function upsample({ width, height, channels }: FeatureMap): FeatureMap {
  const [w, h] = [2 * width, 2 * height];
  const enlarged = channels.map((channel) => {
    const out = emptyChannel(w, h);
    for (let y = 0; y < h; y++)
      for (let x = 0; x < w; x++)
        out[(y + 1) * (w + 2) + x + 1] = channel[((y >> 1) + 1) * (width + 2) + (x >> 1) + 1]!;
    return out;
  });
  return { width: w, height: h, channels: enlarged };
}
