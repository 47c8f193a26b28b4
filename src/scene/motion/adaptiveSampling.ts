/** Times between which paths are nearly straight. */
export interface SampledTimes {
  /** The given times and those added between them, increasing. */
  readonly times: Float64Array;
  /** Greatest remaining distance from a chord [m]. */
  readonly error: number;
  /** Estimated number of times that would meet the tolerance everywhere; the number of `times` if they do. */
  readonly needed: number;
}

/** When a path is close enough to its chords. */
export interface ChordCriterion {
  /** Greatest accepted distance from the chord [m]. */
  readonly tolerance: number;
  /** Fractions between two times at which a path is compared with its chord, including 0.5. */
  readonly fractions: readonly number[];
  /** Greatest number of halvings of an interval between two given times. */
  readonly maxHalvings: number;
  /** Times at the end of an interval that is a ramp and is not subdivided. */
  readonly ramps?: ReadonlySet<number>;
}

/**
 * Adds times to a path until its points (`shape`: 3 numbers each, at a time) stay near the chords between samples. Every piece of the
 * path is evaluated once and cached, since things that share a path may ask for different numbers of times.
 */
export class AdaptivePath {
  readonly samples: Float64Array;
  private readonly shape: (time: number) => ArrayLike<number>;
  private readonly how: ChordCriterion;
  private readonly first: number;
  private readonly pieces = new PathPieces();
  private readonly places: PathPositions;
  /** The points in the middle of the current piece. */
  private readonly middle: Float64Array;
  /** By number of added times. */
  private readonly cached = new Map<number, SampledTimes>();
  /** Number of added times that meets the criterion; undefined until it is found. */
  private enough: number | undefined;

  /** `samples`: increasing; `shape` may return the same array each time. */
  constructor(samples: Float64Array, shape: (time: number) => ArrayLike<number>, how: ChordCriterion) {
    this.samples = samples;
    this.shape = shape;
    this.how = how;
    this.places = new PathPositions(samples, shape);
    this.middle = new Float64Array(this.places.width);
    for (let i = 1; i < samples.length; i++) if (!how.ramps?.has(samples[i])) this.pieces.add(i - 1, i);
    this.first = this.pieces.count;
  }

  /** Cost of one added time, which makes two pieces that are evaluated. */
  get evaluationsPerTime(): number {
    return 2 * this.how.fractions.length;
  }

  /**
   * The samples and at most `max` times between them, until the points move along chords. Intervals are halved breadth-first,
   * so that if `max` ends it, the remaining error is spread over the whole motion.
   */
  sample(max: number): SampledTimes {
    const cached = this.cached.get(Math.min(max, this.enough ?? max));
    if (cached) return cached;
    const found = this.subdivided(max);
    const added = found.times.length - this.samples.length;
    this.cached.set(added, found);
    if (added < max) {
      this.enough = added;
      this.places.forgetShapes();
    }
    return found;
  }

  private subdivided(max: number): SampledTimes {
    const { tolerance, maxHalvings } = this.how;
    const added: number[] = [];
    let [error, missing] = [0, 0];
    let pieces: number[] = [];
    for (let piece = 0; piece < this.first; piece++) pieces.push(piece);
    for (let halvings = maxHalvings; pieces.length > 0; halvings--) {
      const halves: number[] = [];
      for (const piece of pieces) {
        const distance = this.chordDistance(piece, halvings);
        const half = this.pieces.half[piece];
        if (half !== NONE && added.length < max) {
          added.push(this.places.times[this.pieces.to[half]]);
          halves.push(half, half + 1);
          continue;
        }
        error = Math.max(error, distance);
        // The distance of a smooth path from its chord is proportional to the square of the interval.
        if (distance > tolerance) missing += Math.ceil(Math.sqrt(distance / tolerance)) - 1;
      }
      pieces = halves;
    }
    const times = added.length === 0 ? this.samples : joined(this.samples, added).sort();
    return { times, error, needed: missing + times.length };
  }

  private chordDistance(piece: number, halvings: number): number {
    const { distance } = this.pieces;
    if (distance[piece] === NOT_EVALUATED) this.evaluate(piece, halvings);
    return distance[piece];
  }

  /** Computes the greatest distance of a piece's points from its chord, and splits the piece in halves if that is too great. */
  private evaluate(piece: number, halvings: number): void {
    const { from, to, distance, half } = this.pieces;
    const places = this.places;
    const [a, b] = [from[piece], to[piece]];
    const [start, end] = [places.times[a], places.times[b]];
    let worst = 0;
    for (const s of this.how.fractions) {
      const points = this.shape(start + (end - start) * s);
      worst = Math.max(worst, places.chordError(a, b, points, s));
      if (s === 0.5) copy(points, this.middle, 0);
    }
    distance[piece] = worst;
    const time = (start + end) / 2;
    if (!(worst > this.how.tolerance) || !Number.isFinite(worst) || halvings === 0 || !(time > start && time < end))
      return;
    const between = places.add(time, this.middle);
    half[piece] = this.pieces.add(a, between);
    this.pieces.add(between, b);
  }
}

function joined(a: ArrayLike<number>, b: ArrayLike<number>): Float64Array {
  const both = new Float64Array(a.length + b.length);
  both.set(a);
  both.set(b, a.length);
  return both;
}

/** `half` of a piece without halves. */
const NONE = 0;
/** `distance` of a piece that has not been evaluated. */
const NOT_EVALUATED = -1;

/** Pieces of a path between two of its times; the two halves of a piece are consecutive. */
class PathPieces {
  readonly from: number[] = [];
  readonly to: number[] = [];
  /** Greatest distance from the chord [m]. */
  readonly distance: number[] = [];
  /** Index of the first half. */
  readonly half: number[] = [];

  get count(): number {
    return this.from.length;
  }

  add(from: number, to: number): number {
    this.distance.push(NOT_EVALUATED);
    this.half.push(NONE);
    this.to.push(to);
    return this.from.push(from) - 1;
  }
}

function copy(from: ArrayLike<number>, to: Float64Array, at: number): void {
  for (let i = 0; i < from.length; i++) to[at + i] = from[i];
}

/** The points of a path at some times. */
class PathPositions {
  readonly times: number[] = [];
  /** Numbers at one time. */
  readonly width: number;
  private shapes: Float64Array;

  /** `times`: at least one. */
  constructor(times: Float64Array, shape: (time: number) => ArrayLike<number>) {
    const first = shape(times[0]);
    this.width = first.length;
    this.shapes = new Float64Array(this.width * times.length);
    for (let i = 0; i < times.length; i++) this.add(times[i], i === 0 ? first : shape(times[i]));
  }

  add(time: number, shape: ArrayLike<number>): number {
    const at = this.times.length * this.width;
    if (at + this.width > this.shapes.length) {
      const grown = new Float64Array(2 * at + this.width);
      grown.set(this.shapes);
      this.shapes = grown;
    }
    copy(shape, this.shapes, at);
    return this.times.push(time) - 1;
  }

  /** Frees memory once all pieces have been evaluated. */
  forgetShapes(): void {
    this.shapes = new Float64Array(0);
  }

  /** Greatest distance of points from the chords between times `a` and `b` at fraction `s`. */
  chordError(a: number, b: number, points: ArrayLike<number>, s: number): number {
    const shapes = this.shapes;
    let [p, q, worst] = [a * this.width, b * this.width, 0];
    for (let i = 0; i + 2 < points.length; i += 3, p += 3, q += 3) {
      const x = points[i] - shapes[p] - (shapes[q] - shapes[p]) * s;
      const y = points[i + 1] - shapes[p + 1] - (shapes[q + 1] - shapes[p + 1]) * s;
      const z = points[i + 2] - shapes[p + 2] - (shapes[q + 2] - shapes[p + 2]) * s;
      worst = Math.max(worst, x * x + y * y + z * z);
    }
    return Math.sqrt(worst);
  }
}

/**
 * The number of evaluations of a transform that a scene may still spend on adaptive paths: a small file can ask for
 * any number of turns of any number of things. If the number of motions is known, each gets at most an equal share of the rest; otherwise half of it, so
 * that one extreme motion does not use up the budget of all others.
 */
export class SamplingBudget {
  private left: number;
  /** Greatest remaining distance from a chord so far [m]; undefined before the first motion. */
  error: number | undefined;
  /** Motions that are still to come, if known. */
  private waiting: number | undefined;

  /** `motions`: how many there will be. */
  constructor(evaluations: number, motions?: number) {
    this.left = evaluations;
    this.waiting = motions;
  }

  /** Records the greatest distance of a motion from its chords [m]: 0 if it is on them. */
  record(error: number): void {
    this.error = Math.max(this.error ?? 0, error);
  }

  /** Samples a path within the budget; `cost`: evaluations that its points at one time take; `most`: times that there may be, if its own are not more. */
  sample(path: AdaptivePath, cost: number, most = Number.POSITIVE_INFINITY): SampledTimes {
    const each = path.evaluationsPerTime * cost;
    const share = this.waiting === undefined ? 2 : Math.max(1, this.waiting--);
    const added = Math.floor(Math.min(this.left / share / each, Math.max(0, most - path.samples.length)));
    const refined = path.sample(added);
    this.record(refined.error);
    this.left -= (refined.times.length - path.samples.length) * each;
    return refined;
  }
}
