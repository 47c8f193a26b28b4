/** At most `count` of the times, evenly spaced, including the first and last. */
export function subsampleEvenly<T extends ArrayLike<number>>(times: T, most: number): T | Float64Array {
  if (times.length <= most) return times;
  return Float64Array.from({ length: most }, (_, i) => times[Math.round((i * (times.length - 1)) / (most - 1))]);
}
