/** Times such that paths between them are nearly straight. */
export interface SampledTimes {
  /** The given ones, and those added between them; rising. */
  readonly times: Float64Array;
  /** Greatest distance from a chord that is left [m]. */
  readonly error: number;
  /** About how many times keep the tolerance everywhere: as many as there are, unless they were too few. */
  readonly needed: number;
}

/** How closely a path is followed. */
export interface ChordCriterion {
  /** Greatest distance from the chord that a path is left with [m]. */
  readonly tolerance: number;
  /** Where between two times a path is compared with its chord, as fractions; 0.5 among them. */
  readonly fractions: readonly number[];
  /** An interval between two given times is halved at most this often. */
  readonly maxHalvings: number;
  /** Times before which a path is a ramp as it is, and not looked at. */
  readonly ramps?: ReadonlySet<number>;
}

/**
 * How far some points (`shape`: 3 numbers each, at a time) move from the chords between samples. Every piece of the path is
 * looked at once, however often it is asked for: things that share a path may have different numbers of times.
 */
export class AdaptivePath {
  readonly samples: Float64Array;
  private readonly shape: (time: number) => ArrayLike<number>;
  private readonly how: ChordCriterion;
  private readonly first: number;
  private readonly pieces = new PathPieces();
  private readonly places: PathPositions;
  /** Where the points are in the middle of the piece at hand. */
  private readonly middle: Float64Array;
  /** By how many times are added. */
  private readonly known = new Map<number, SampledTimes>();
  /** How many are, where nothing but the path itself ends it; once that is known. */
  private enough: number | undefined;

  /** `samples`: rising; `shape` may write each of its answers into the same array. */
  constructor(samples: Float64Array, shape: (time: number) => ArrayLike<number>, how: ChordCriterion) {
    this.samples = samples;
    this.shape = shape;
    this.how = how;
    this.places = new PathPositions(samples, shape);
    this.middle = new Float64Array(this.places.width);
    for (let i = 1; i < samples.length; i++) if (!how.ramps?.has(samples[i])) this.pieces.add(i - 1, i);
    this.first = this.pieces.count;
  }

  /** What one added time takes: it makes two pieces, each to be looked at. */
  get evaluationsPerTime(): number {
    return 2 * this.how.fractions.length;
  }

  /**
   * The samples and at most so many times between them, until the points move along chords. All intervals are halved alike
   * before any is halved again, so that where `most` ends it, what is left is spread over all of the motion.
   */
  sample(most: number): SampledTimes {
    const known = this.known.get(Math.min(most, this.enough ?? most));
    if (known) return known;
    const found = this.halved(most);
    const added = found.times.length - this.samples.length;
    this.known.set(added, found);
    if (added < most) {
      this.enough = added;
      this.places.forgetShapes();
    }
    return found;
  }

  private halved(most: number): SampledTimes {
    const { tolerance, maxHalvings } = this.how;
    const added: number[] = [];
    let [error, wanted] = [0, 0];
    let pieces: number[] = [];
    for (let piece = 0; piece < this.first; piece++) pieces.push(piece);
    for (let left = maxHalvings; pieces.length > 0; left--) {
      const halves: number[] = [];
      for (const piece of pieces) {
        const off = this.offOf(piece, left);
        const half = this.pieces.half[piece];
        if (half !== NONE && added.length < most) {
          added.push(this.places.times[this.pieces.to[half]]);
          halves.push(half, half + 1);
          continue;
        }
        error = Math.max(error, off);
        // A chord over a part h of a smooth path leaves it by h².
        if (off > tolerance) wanted += Math.ceil(Math.sqrt(off / tolerance)) - 1;
      }
      pieces = halves;
    }
    const times = added.length === 0 ? this.samples : joined(this.samples, added).sort();
    return { times, error, needed: wanted + times.length };
  }

  private offOf(piece: number, left: number): number {
    const { off } = this.pieces;
    if (off[piece] === UNSEEN) this.look(piece, left);
    return off[piece];
  }

  /** How far the points of a piece are from its chord, at the worst look; it has halves where that is too far. */
  private look(piece: number, left: number): void {
    const { from, to, off, half } = this.pieces;
    const places = this.places;
    const [a, b] = [from[piece], to[piece]];
    const [start, end] = [places.times[a], places.times[b]];
    let worst = 0;
    for (const s of this.how.fractions) {
      const seen = this.shape(start + (end - start) * s);
      worst = Math.max(worst, places.chordError(a, b, seen, s));
      if (s === 0.5) copy(seen, this.middle, 0);
    }
    off[piece] = worst;
    const time = (start + end) / 2;
    if (!(worst > this.how.tolerance) || !Number.isFinite(worst) || left === 0 || !(time > start && time < end)) return;
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

/** Of a piece without halves. */
const NONE = 0;
/** Of a piece that nobody has looked at. */
const UNSEEN = -1;

/** Pieces of a path between two of its places; the halves of one follow each other. */
class PathPieces {
  readonly from: number[] = [];
  readonly to: number[] = [];
  /** Distance from the chord [m]. */
  readonly off: number[] = [];
  /** The first half. */
  readonly half: number[] = [];

  get count(): number {
    return this.from.length;
  }

  add(from: number, to: number): number {
    this.off.push(UNSEEN);
    this.half.push(NONE);
    this.to.push(to);
    return this.from.push(from) - 1;
  }
}

function copy(from: ArrayLike<number>, to: Float64Array, at: number): void {
  for (let i = 0; i < from.length; i++) to[at + i] = from[i];
}

/** Where the points are at some times. */
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

  /** Once all pieces have been looked at. */
  forgetShapes(): void {
    this.shapes = new Float64Array(0);
  }

  /** Greatest distance of points from where straight ways from place `a` to `b` have them at fraction `s`. */
  chordError(a: number, b: number, seen: ArrayLike<number>, s: number): number {
    const shapes = this.shapes;
    let [p, q, worst] = [a * this.width, b * this.width, 0];
    for (let i = 0; i + 2 < seen.length; i += 3, p += 3, q += 3) {
      const x = seen[i] - shapes[p] - (shapes[q] - shapes[p]) * s;
      const y = seen[i + 1] - shapes[p + 1] - (shapes[q + 1] - shapes[p + 1]) * s;
      const z = seen[i + 2] - shapes[p + 2] - (shapes[q + 2] - shapes[p + 2]) * s;
      worst = Math.max(worst, x * x + y * y + z * z);
    }
    return Math.sqrt(worst);
  }
}

/**
 * What a scene may still spend on looking at paths between samples [evaluations of a transform]: a small file can ask for
 * any number of turns of any number of things. Of what is left each motion gets half at most, so that one wild thing does
 * not take it from all.
 */
export class SamplingBudget {
  private left: number;
  /** Greatest distance from a chord that was left so far [m]; undefined before the first motion. */
  error: number | undefined;
  constructor(evaluations: number) {
    this.left = evaluations;
  }

  /** Says that a motion needs no times between its own: it leaves no chord. */
  markExact(): void {
    this.error ??= 0;
  }

  /** As many times of a path as the budget has room for; `cost` [evaluations]: of where its points are at one time. */
  sample(path: AdaptivePath, cost: number): SampledTimes {
    const each = path.evaluationsPerTime * cost;
    const refined = path.sample(Math.floor(this.left / 2 / each));
    this.error = Math.max(this.error ?? 0, refined.error);
    this.left -= (refined.times.length - path.samples.length) * each;
    return refined;
  }
}
