type FingerPlace = readonly [x: number, y: number];

/** What fingers on the picture ask for. */
export interface FingerMove {
  /** How far a single finger has dragged [px]. */
  readonly drag: FingerPlace;
  /** How many times farther apart two fingers are. */
  readonly spread: number;
  /** How far two fingers have twisted [rad], anticlockwise as roll is. */
  readonly twist: number;
}
const NOTHING: FingerMove = { drag: [0, 0], spread: 1, twist: 0 };

/** Fingers that have moved less rest [px]. */
const REST = 8;
/** Two fingers spread, or twist, from such changes on [px, rad]: nobody does one without a little of the other. */
const LEAST_SPREAD = 14;
const LEAST_TWIST = 0.15;

/** Two fingers as they were last heard of. */
interface FingerPair {
  distance: number;
  direction: number;
  spreads: boolean;
  twists: boolean;
}

/** Fingers on the picture: one drags, taps or rests; two spread or twist. */
export class TouchGestures {
  private readonly fingers = new Map<number, FingerPlace>();
  private pair: FingerPair | undefined;
  private from: FingerPlace = [0, 0];
  /** Whether one finger alone is down and has not moved. */
  private rests = false;

  down(id: number, x: number, y: number): void {
    this.fingers.set(id, [x, y]);
    this.from = [x, y];
    this.rests = this.fingers.size === 1;
    this.pair = this.fingers.size === 2 ? { ...this.between(), spreads: false, twists: false } : undefined;
  }

  move(id: number, x: number, y: number): FingerMove {
    const before = this.fingers.get(id);
    if (!before) return NOTHING;
    this.fingers.set(id, [x, y]);
    if (this.pair) return this.movePair(this.pair);
    if (this.fingers.size > 1) return NOTHING;
    if (this.rests) {
      this.rests = Math.hypot(x - this.from[0], y - this.from[1]) < REST;
      return NOTHING;
    }
    return { ...NOTHING, drag: [x - before[0], y - before[1]] };
  }

  /** Returns where that was a tap, if it was one. */
  up(id: number): FingerPlace | undefined {
    const at = this.fingers.get(id);
    this.fingers.delete(id);
    this.pair = undefined;
    const tapped = this.rests ? at : undefined;
    this.rests = false;
    return tapped;
  }

  /** Where one finger rests. Whoever acts on that ends the gesture: what follows is no tap. */
  takeRest(): FingerPlace | undefined {
    if (!this.rests) return undefined;
    this.rests = false;
    return this.from;
  }

  private movePair(pair: FingerPair): FingerMove {
    const { distance, direction } = this.between();
    const turned = wrapped(pair.direction - direction);
    const [{ spreads, twists }, before] = [pair, pair.distance];
    if (spreads || Math.abs(distance - before) > LEAST_SPREAD) Object.assign(pair, { distance, spreads: true });
    if (twists || Math.abs(turned) > LEAST_TWIST) Object.assign(pair, { direction, twists: true });
    return { ...NOTHING, spread: spreads ? distance / before : 1, twist: twists ? turned : 0 };
  }

  /** How far apart two fingers are [px], and the direction from one to the other [rad], clockwise as y is down. */
  private between(): { readonly distance: number; readonly direction: number } {
    const [a = [0, 0], b = [0, 0]] = this.fingers.values();
    const [x, y] = [b[0] - a[0], b[1] - a[1]];
    return { distance: Math.max(1, Math.hypot(x, y)), direction: Math.atan2(y, x) };
  }
}

/** An angle between −π and π. */
const wrapped = (angle: number): number => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
