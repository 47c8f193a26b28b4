/** Times such that paths between them are nearly straight. */
export interface RefinedTimes {
  /** The given ones, and those added between them; rising. */
  readonly times: Float64Array;
  /** Greatest distance from a chord that is left [m]. */
  readonly error: number;
  /** About how many times keep the tolerance everywhere: as many as there are, unless they were too few. */
  readonly wanted: number;
}

export interface Refinement {
  /** Greatest distance from the chord that a path is left with [m]. */
  readonly tolerance: number;
  /** Where between two times a path is compared with its chord, as fractions; 0.5 among them. */
  readonly looks: readonly number[];
  /** An interval between two given times is halved at most this often. */
  readonly halvings: number;
  /** At most so many times are added. */
  readonly most: number;
  /** Times before which a path is a ramp as it is, and not looked at. */
  readonly ramps?: ReadonlySet<number>;
}

interface Piece {
  readonly from: number;
  readonly to: number;
  readonly atFrom: ArrayLike<number>;
  readonly atTo: ArrayLike<number>;
}

/**
 * Adds times between samples until some points (`shape`: 3 numbers each, at a time) move along chords. All intervals are
 * halved alike before any is halved again, so that where `most` ends it, what is left is spread over all of the motion.
 */
export function refineTimes(
  samples: ArrayLike<number>,
  shape: (time: number) => ArrayLike<number>,
  { tolerance, looks, halvings, most, ramps }: Refinement,
): RefinedTimes {
  const times = Array.from(samples);
  let [error, wanted] = [0, 0];
  let pieces = piecesBetween(times, shape, ramps);
  for (let left = halvings; pieces.length > 0; left--) {
    const halves: Piece[] = [];
    for (const piece of pieces) {
      const { off, middle } = lookAt(piece, looks, shape);
      if (
        off <= tolerance ||
        !canHalve(piece) ||
        !Number.isFinite(off) ||
        left === 0 ||
        times.length >= samples.length + most
      ) {
        error = Math.max(error, off);
        // A chord over a part h of a smooth path leaves it by h².
        if (off > tolerance) wanted += Math.ceil(Math.sqrt(off / tolerance)) - 1;
        continue;
      }
      const time = (piece.from + piece.to) / 2;
      times.push(time);
      halves.push({ ...piece, to: time, atTo: middle }, { ...piece, from: time, atFrom: middle });
    }
    pieces = halves;
  }
  return { times: Float64Array.from(times).sort(), error, wanted: wanted + times.length };
}

function piecesBetween(
  times: readonly number[],
  shape: (time: number) => ArrayLike<number>,
  ramps?: ReadonlySet<number>,
) {
  const shapes = times.map(shape);
  const pieces: Piece[] = [];
  for (let i = 1; i < times.length; i++)
    if (!ramps?.has(times[i]))
      pieces.push({ from: times[i - 1], to: times[i], atFrom: shapes[i - 1], atTo: shapes[i] });
  return pieces;
}

function canHalve({ from, to }: Piece): boolean {
  const middle = (from + to) / 2;
  return middle > from && middle < to;
}

/** How far the points are from the chord, at the worst look, and where they are in the middle. */
function lookAt(
  { from, to, atFrom, atTo }: Piece,
  looks: readonly number[],
  shape: (time: number) => ArrayLike<number>,
) {
  let off = 0;
  let middle = atFrom;
  for (const s of looks) {
    const seen = shape(from + (to - from) * s);
    if (s === 0.5) middle = seen;
    off = Math.max(off, chordError(atFrom, atTo, seen, s));
  }
  return { off, middle };
}

/** Greatest distance of points from where straight ways from `a` to `b` have them at fraction `s`. */
function chordError(a: ArrayLike<number>, b: ArrayLike<number>, seen: ArrayLike<number>, s: number): number {
  let worst = 0;
  for (let i = 0; i + 2 < seen.length; i += 3) {
    const x = seen[i] - a[i] - (b[i] - a[i]) * s;
    const y = seen[i + 1] - a[i + 1] - (b[i + 1] - a[i + 1]) * s;
    const z = seen[i + 2] - a[i + 2] - (b[i + 2] - a[i + 2]) * s;
    worst = Math.max(worst, x * x + y * y + z * z);
  }
  return Math.sqrt(worst);
}

/**
 * What a scene may still spend on looking at paths between samples [evaluations of a transform]: a small file can ask for
 * any number of turns of any number of things. Of what is left each motion gets half at most, so that one wild thing does
 * not take it from all.
 */
export class RefinementBudget {
  #left: number;
  /** Greatest distance from a chord that was left so far [m]; undefined before the first motion. */
  error: number | undefined;
  constructor(evaluations: number) {
    this.#left = evaluations;
  }

  /** Says that a motion needs no times between its own: it leaves no chord. */
  keepExact(): void {
    this.error ??= 0;
  }

  /** `refineTimes` within the budget; `cost` [evaluations]: of one call of `shape`. */
  refine(
    samples: ArrayLike<number>,
    shape: (time: number) => ArrayLike<number>,
    how: Omit<Refinement, 'most'>,
    cost: number,
  ): RefinedTimes {
    // An added time makes two pieces, each to be looked at.
    const each = 2 * how.looks.length * cost;
    const refined = refineTimes(samples, shape, { ...how, most: Math.floor(this.#left / 2 / each) });
    this.error = Math.max(this.error ?? 0, refined.error);
    this.#left -= (refined.times.length - samples.length) * each;
    return refined;
  }
}
