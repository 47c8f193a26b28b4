import type { Curve } from './curves.ts';

/** Times between which an object's path is drawn straight, and those of them at which it may not be refined. */
export interface Knots {
  /** [s], strictly rising. */
  readonly times: readonly number[];
  /** Ends of the short ramps that stand for jumps. */
  readonly jumps: ReadonlySet<number>;
}

/** A jump becomes a ramp of this length [s], or half the time since the key before, where that is shorter. */
export const JUMP_RAMP = 1e-3;
/** A piece between two keys is halved at most this many times. */
const MAX_HALVINGS = 12;
/** Beyond this many samples no piece is halved any more, so that a file of nonsense ends too. */
const MAX_SAMPLES = 2 ** 16;
/** Inside a piece a path is looked at here: in the middle and at two places that no periodic motion has in common. */
const LOOKS = [0.23, 0.5, 0.71];

/** All key times of some curves; before each jump there is one more, so that the jump is a short ramp. */
export function knotsOf(curves: readonly Curve[]): Knots {
  const keys = [...new Set(curves.flatMap((curve) => [...curve.times]))].sort((a, b) => a - b);
  const jumps = new Set(curves.flatMap((curve) => curve.jumps));
  const times: number[] = [];
  for (const [i, t] of keys.entries()) {
    const ramp = i > 0 ? Math.min(JUMP_RAMP, (t - keys[i - 1]) / 2) : JUMP_RAMP;
    if (jumps.has(t)) times.push(t - ramp);
    times.push(t);
  }
  return { times, jumps };
}

/**
 * Sample times such that straight lines between them leave the true path by no more than `tolerance`: pieces are halved
 * until they do. `shape` gives some points (3 numbers each) whose paths matter, at a time.
 */
export function sampleTimes(knots: Knots, shape: (t: number) => ArrayLike<number>, tolerance: number): number[] {
  const out = knots.times.slice(0, 1);
  for (let i = 1; i < knots.times.length; i++) {
    const [from, to] = [knots.times[i - 1], knots.times[i]];
    if (!knots.jumps.has(to)) refine(from, shape(from), to, shape(to), MAX_HALVINGS);
    out.push(to);
  }
  return out;

  function refine(a: number, atA: ArrayLike<number>, b: number, atB: ArrayLike<number>, halvings: number): void {
    const looks = LOOKS.map((s) => shape(a + (b - a) * s));
    const worst = Math.max(...looks.map((look, i) => chordError(atA, atB, look, LOOKS[i])));
    const middle = (a + b) / 2;
    if (!(worst > tolerance) || halvings === 0 || out.length >= MAX_SAMPLES || middle <= a || middle >= b) return;
    refine(a, atA, middle, looks[1], halvings - 1);
    out.push(middle);
    refine(middle, looks[1], b, atB, halvings - 1);
  }
}

/** Greatest distance of the points from where straight lines from `a` to `b` have them at fraction `s`. */
function chordError(a: ArrayLike<number>, b: ArrayLike<number>, look: ArrayLike<number>, s: number): number {
  let worst = 0;
  for (let i = 0; i + 2 < look.length; i += 3) {
    let square = 0;
    for (let k = i; k < i + 3; k++) square += (a[k] + (b[k] - a[k]) * s - look[k]) ** 2;
    worst = Math.max(worst, square);
  }
  return Math.sqrt(worst);
}
