/** Distribution of luminance over stops as the tone curve gets it: exposed, white at 0. */
export interface LuminanceHistogram {
  /** Bins of equal width over `STOP_RANGE`; the fullest is 1. The outermost include all beyond. */
  readonly bins: readonly number[];
  /** Median of the luminance above 0 [EV]; 0 if there is none. */
  readonly middle: number;
  /** Fraction of pixels above white, 0 … 1. */
  readonly over: number;
}

/** Range of the histogram [EV]. */
export const STOP_RANGE: readonly [from: number, to: number] = [-12, 4];
const BINS = 48;

/** Bins log₂(luminance · 2^exposure); zero luminance is not counted. */
export function luminanceHistogram(luminance: ArrayLike<number>, exposure: number): LuminanceHistogram {
  const stops = Float64Array.from(luminance, (light) => Math.log2(light) + exposure)
    .filter(Number.isFinite)
    .sort();
  const counts = new Array<number>(BINS).fill(0);
  const [from, to] = STOP_RANGE;
  for (const stop of stops) {
    const bin = Math.floor((BINS * (stop - from)) / (to - from));
    counts[Math.min(BINS - 1, Math.max(0, bin))]!++;
  }
  const most = Math.max(1, ...counts);
  const over = stops.filter((stop) => stop > 0).length / Math.max(1, luminance.length);
  return { bins: counts.map((count) => count / most), middle: stops[stops.length >> 1] ?? 0, over };
}
