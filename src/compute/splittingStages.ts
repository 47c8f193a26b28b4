/** One pass over all points: kick p, drift x, damp p, drift x. */
export interface SplittingStage {
  /** p += kick · F(x) [s] */
  readonly kick: number;
  /** x += drift · v [s] */
  readonly drift: number;
  /** p −= damp · p */
  readonly damp: number;
  /** x += after · v, with the new p [s] */
  readonly after: number;
  /** Drift of x since the previous pass [s]; 0: F is not evaluated. */
  readonly before: number;
}

/**
 * Steps of a splitting method as passes with one force evaluation each: the half drifts at the end of a step and at the
 * start of the next are merged into one pass. `begin` runs once, `within` in each step, then `between` two steps, and
 * `end` after the last. `shares`: coefficients of the `IntegrationMethod`; drag: half before each and half after it.
 */
export interface SplittingStages {
  readonly begin: SplittingStage;
  readonly within: readonly SplittingStage[];
  readonly between: SplittingStage;
  readonly end: SplittingStage;
}

export function splittingStagesOf(fractions: readonly number[], h: number, drag: number): SplittingStages {
  const last = fractions.length - 1;
  const half = (k: number | undefined): number => (k === undefined ? 0 : (fractions[k] * h) / 2);
  const damp = (time: number): number => -Math.expm1(-drag * time);
  /** The k-th kick, and what follows until the next. */
  const pass = (k: number, next?: number): SplittingStage => ({
    ...{ kick: fractions[k] * h, drift: half(k), damp: damp(half(k) + half(next)), after: half(next) },
    before: half(k === 0 ? last : k - 1) + half(k),
  });
  return {
    begin: { kick: 0, drift: 0, damp: damp(half(0)), after: half(0), before: 0 },
    within: fractions.slice(1).map((_, k) => pass(k, k + 1)),
    between: pass(last, 0),
    end: pass(last),
  };
}
