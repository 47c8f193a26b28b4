/** What a set of errors comes to; `undefined` where there is none. */
export interface ErrorSummary {
  readonly mean: number;
  readonly max: number;
  /** 99 of 100 are at most this. */
  readonly p99: number;
}

export function summarize(errors: ArrayLike<number>): ErrorSummary | undefined {
  if (errors.length === 0) return undefined;
  const sorted = Float64Array.from(errors).sort();
  const sum = sorted.reduce((total, error) => total + error, 0);
  const p99 = sorted[Math.ceil(0.99 * sorted.length) - 1];
  return { mean: sum / errors.length, max: sorted[sorted.length - 1], p99 };
}

/** The part of all, 0 … 1, that is larger than `threshold`. */
export function shareAbove(errors: ArrayLike<number>, threshold: number): number {
  let above = 0;
  for (let i = 0; i < errors.length; i++) if (errors[i] > threshold) above++;
  return errors.length > 0 ? above / errors.length : 0;
}
