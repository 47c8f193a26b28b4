/** How light is spread over stops, as a tone curve gets it: exposed, white at 0. */
export interface LuminanceHistogram {
  /** From `STOPS[0]` to `STOPS[1]`, evenly; the fullest is 1. What lies beyond is in the outermost. */
  readonly bins: readonly number[];
  /** Half of what is lit is below this [EV]; 0 where nothing is. */
  readonly middle: number;
  /** The share of all that is above white, 0 … 1. */
  readonly over: number;
}

/** From the darkest to the brightest that is told apart [EV]. */
export const STOP_RANGE: readonly [from: number, to: number] = [-12, 4];
const BINS = 48;

/** log₂ of luminance · 2^exposure; what has no light at all is in no bin. */
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
