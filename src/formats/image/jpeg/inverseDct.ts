/** Samples a side of a block. */
export const SIDE = 8;

/** cos and sin of π/16 and 3π/16, √2 cos and √2 sin of 6π/16, √2 and √½, in 12 bits. */
const [COS1, SIN1, COS3, SIN3, COS6, SIN6, SQRT2, SQRT_HALF] = [4017, 799, 3406, 2276, 1567, 3784, 5793, 2896];

/** Where a block's samples go: to `at` of `samples`, in rows `stride` apart. */
export interface BlockPlace {
  readonly samples: Uint8Array;
  readonly at: number;
  readonly stride: number;
}

const work = new Int32Array(SIDE * SIDE);

/** The samples of the block whose coefficients, in rows, begin at `first`; each is multiplied by its quantization step. */
export function inverseDct(coefficients: Int16Array, first: number, steps: Uint16Array, place: BlockPlace): void {
  for (let i = 0; i < SIDE * SIDE; i++) work[i] = coefficients[first + i] * steps[i];
  // After the rows numbers have 4 more bits, which the last step takes away.
  for (let y = 0; y < SIDE; y++) transform(SIDE * y, 1, 8);
  for (let x = 0; x < SIDE; x++) transform(x, SIDE, 12);
  for (let y = 0, i = 0; y < SIDE; y++)
    for (let x = 0; x < SIDE; x++, i++) place.samples[place.at + y * place.stride + x] = sampleOf(work[i]);
}

/** The same of a block that has only its mean. */
export function inverseDctOfMean(mean: number, { samples, at, stride }: BlockPlace): void {
  const sample = sampleOf(flat(flat(mean, 8), 12));
  for (let y = 0; y < SIDE; y++) samples.fill(sample, at + y * stride, at + y * stride + SIDE);
}

const flat = (mean: number, bits: number): number => (SQRT2 * mean + (1 << (bits + 1))) >> (bits + 2);

const sampleOf = (x: number): number => Math.max(0, Math.min(255, 128 + ((x + 8) >> 4)));

/**
 * One dimension, of 8 numbers `step` apart; `bits` are rounded away. Loeffler, Ligtenberg & Moschytz 1989, "Practical fast
 * 1-D DCT algorithms with 11 multiplications", Proc. ICASSP, p. 988.
 */
function transform(first: number, step: number, bits: number): void {
  const [i1, i2, i3, i4] = [first + step, first + 2 * step, first + 3 * step, first + 4 * step];
  const [i5, i6, i7] = [first + 5 * step, first + 6 * step, first + 7 * step];
  const [p0, p1, p2, p3, p4, p5, p6, p7] = [
    work[first],
    work[i1],
    work[i2],
    work[i3],
    work[i4],
    work[i5],
    work[i6],
    work[i7],
  ];
  if ((p1 | p2 | p3 | p4 | p5 | p6 | p7) === 0) {
    const t = flat(p0, bits);
    work[first] = work[i1] = work[i2] = work[i3] = work[i4] = work[i5] = work[i6] = work[i7] = t;
    return;
  }
  const half = 1 << (bits - 1);
  const a0 = (SQRT2 * p0 + half) >> bits;
  const a1 = (SQRT2 * p4 + half) >> bits;
  const a4 = (SQRT_HALF * (p1 - p7) + half) >> bits;
  const a7 = (SQRT_HALF * (p1 + p7) + half) >> bits;
  const a5 = p3 << (12 - bits);
  const a6 = p5 << (12 - bits);

  const b0 = (a0 + a1 + 1) >> 1;
  const b1 = (a0 - a1 + 1) >> 1;
  const b2 = (p2 * COS6 - p6 * SIN6 + half) >> bits;
  const b3 = (p2 * SIN6 + p6 * COS6 + half) >> bits;
  const b4 = (a4 + a6 + 1) >> 1;
  const b6 = (a4 - a6 + 1) >> 1;
  const b5 = (a7 - a5 + 1) >> 1;
  const b7 = (a7 + a5 + 1) >> 1;

  const c0 = (b0 + b3 + 1) >> 1;
  const c3 = (b0 - b3 + 1) >> 1;
  const c1 = (b1 + b2 + 1) >> 1;
  const c2 = (b1 - b2 + 1) >> 1;
  const c4 = (b4 * COS3 - b7 * SIN3 + 2048) >> 12;
  const c7 = (b4 * SIN3 + b7 * COS3 + 2048) >> 12;
  const c5 = (b5 * COS1 - b6 * SIN1 + 2048) >> 12;
  const c6 = (b5 * SIN1 + b6 * COS1 + 2048) >> 12;

  work[first] = c0 + c7;
  work[i1] = c1 + c6;
  work[i2] = c2 + c5;
  work[i3] = c3 + c4;
  work[i4] = c3 - c4;
  work[i5] = c2 - c5;
  work[i6] = c1 - c6;
  work[i7] = c0 - c7;
}
