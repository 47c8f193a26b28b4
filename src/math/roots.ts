/**
 * The root of a continuous f between a and b, where f changes sign, to the last bit: halves until no number lies between.
 * @example
 * bisect((x) => x * x - 2, 0, 2); // 1.414213562373
 */
export function bisect(f: (x: number) => number, a: number, b: number): number {
  let [lo, hi] = f(a) <= f(b) ? [a, b] : [b, a];
  for (;;) {
    const mid = lo + (hi - lo) / 2;
    if (mid === lo || mid === hi) return mid;
    if (f(mid) <= 0) lo = mid;
    else hi = mid;
  }
}

/**
 * The root of a continuous f between a and b, where f changes sign: inverse quadratic steps guarded by bisection, until
 * the bracket is `tolerance` or one rounding wide. If f has the same sign at both ends, the end with the smaller |f| is returned.
 * Source: Brent 1973, "Algorithms for Minimization without Derivatives", ch. 4.
 * @example
 * brent((x) => x * x - 2, 0, 2); // 1.414213562373
 */
export function brent(f: (x: number) => number, a: number, b: number, tolerance = 0): number {
  let [fa, fb] = [f(a), f(b)];
  if (fa * fb > 0) return Math.abs(fa) < Math.abs(fb) ? a : b;
  let [c, fc, step, last] = [a, fa, b - a, b - a];
  for (let i = 0; i < 200; i++) {
    if (fb > 0 === fc > 0) [c, fc, step, last] = [a, fa, b - a, b - a];
    if (Math.abs(fc) < Math.abs(fb)) [a, b, c, fa, fb, fc] = [b, c, b, fb, fc, fb];
    const least = 2 * Number.EPSILON * Math.abs(b) + tolerance / 2;
    const half = (c - b) / 2;
    if (Math.abs(half) <= least || fb === 0) return b;
    const guess =
      Math.abs(last) >= least && Math.abs(fa) > Math.abs(fb) ? interpolate(a, b, c, fa, fb, fc) : Number.NaN;
    // False for a NaN guess, which then bisects.
    const good = guess / half > 0 && Math.abs(guess) < Math.min(1.5 * Math.abs(half) - least / 2, Math.abs(last) / 2);
    [last, step] = good ? [step, guess] : [half, half];
    [a, fa] = [b, fb];
    b += Math.abs(step) > least ? step : Math.sign(half) * least;
    fb = f(b);
  }
  return b;
}

/** The step from b to the root of the inverse quadratic (or line) through three points. */
function interpolate(a: number, b: number, c: number, fa: number, fb: number, fc: number): number {
  const s = fb / fa;
  if (a === c) return ((c - b) * s) / (s - 1);
  const [q, r] = [fa / fc, fb / fc];
  return (s * ((c - b) * q * (q - r) - (b - a) * (r - 1))) / -((q - 1) * (r - 1) * (s - 1));
}

/** Upper limit of steps in `safeguardedNewton`; it converges long before. */
const MAX_STEPS = 100;

/**
 * The root of an increasing function between a and b: Newton's steps from `guess`, replaced by bisection where a step leaves the current bracket or
 * the last two steps did not halve it. f returns value and slope. If the root lies beyond an end, that end is returned.
 * @example
 * // Kepler's equation M = E − e sin E, with e = 0.6 and M = 1.
 * safeguardedNewton((E) => [E - 0.6 * Math.sin(E) - 1, 1 - 0.6 * Math.cos(E)], 0, 2, 1); // 1.5997
 */
export function safeguardedNewton(
  f: (x: number) => readonly [value: number, slope: number],
  a: number,
  b: number,
  guess: number,
): number {
  let [lo, hi] = [a, b];
  let x = guess > a && guess < b ? guess : (a + b) / 2;
  let [last, beforeLast] = [b - a, b - a];
  for (let i = 0; i < MAX_STEPS; i++) {
    const [value, slope] = f(x);
    if (value === 0) return x;
    if (value < 0) lo = x;
    else hi = x;
    const newton = x - value / slope;
    const good = newton >= lo && newton <= hi && 2 * Math.abs(newton - x) <= beforeLast;
    const next = good ? newton : lo + (hi - lo) / 2;
    if (Math.abs(next - x) <= 2 * Number.EPSILON * Math.abs(x) || next === lo || next === hi) return next;
    [beforeLast, last] = [last, Math.abs(next - x)];
    x = next;
  }
  return x;
}
