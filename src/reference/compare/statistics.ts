/** Summary statistics of a set of errors. */
export interface ErrorSummary {
  readonly mean: number;
  readonly max: number;
  /** The 99th percentile. */
  readonly p99: number;
}

/** Returns undefined for an empty set. */
export function summarize(errors: ArrayLike<number>): ErrorSummary | undefined {
  if (errors.length === 0) return undefined;
  const sorted = Float64Array.from(errors).sort();
  const sum = sorted.reduce((total, error) => total + error, 0);
  const p99 = sorted[Math.ceil(0.99 * sorted.length) - 1];
  return { mean: sum / errors.length, max: sorted[sorted.length - 1], p99 };
}

/** Fraction of the errors, 0 … 1, above `threshold`; 0 for an empty set. */
export function shareAbove(errors: ArrayLike<number>, threshold: number): number {
  let above = 0;
  for (let i = 0; i < errors.length; i++) if (errors[i] > threshold) above++;
  return errors.length > 0 ? above / errors.length : 0;
}
