/** Wraps world time [s] to the timeline: at the end it loops or stops. */
export function wrapTime(t: number, start: number, end: number, loop: boolean): number {
  if (end <= start || t <= end) return t;
  return loop ? start + ((t - start) % (end - start)) : end;
}
