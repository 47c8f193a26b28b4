/** Fewer pixels while the picture moves and frames are slow, all of them as soon as it rests: a slow machine stays flyable. */

interface Level {
  /** Of the pixels' number along each side, 0 … 1. */
  readonly scale: number;
  /** With what makes a picture more beautiful, and changes nothing in it. */
  readonly fine: boolean;
}

/** Each takes about half as long as the one before. */
const LEVELS: readonly Level[] = [
  { scale: 1, fine: true },
  { scale: 0.7, fine: true },
  { scale: 0.7, fine: false },
  { scale: 0.5, fine: false },
];
/** Frames that take longer [ms] ask for fewer pixels, and shorter ones allow more. */
const SLOW = 70;
const FAST = 22;
/** So long without a change [ms], and the picture rests. */
const REST = 250;
/** Frames between two changes of level, so that each is judged by its own frames. */
const PATIENCE = 6;

export class Resolution {
  /** The level that motion needs on this machine; kept over rests. */
  #level = 0;
  #moving = false;
  #lastChange = Number.NEGATIVE_INFINITY;
  #frames = 0;
  #mean = 0;

  get scale(): number {
    return this.#shown.scale;
  }

  get fine(): boolean {
    return this.#shown.fine;
  }

  get resting(): boolean {
    return !this.#moving;
  }

  get #shown(): Level {
    return LEVELS[this.#moving ? this.#level : 0]!;
  }

  /** After each frame: whether what is to be seen changed, the time now and since the frame before [ms]. */
  note(changed: boolean, now: number, interval: number): void {
    if (!changed) {
      if (now - this.#lastChange > REST) this.#moving = false;
      return;
    }
    // The first frames of a motion also carry what the rest before them cost.
    if (this.#moving) this.#judge(interval);
    this.#moving = true;
    this.#lastChange = now;
  }

  #judge(interval: number): void {
    this.#frames++;
    this.#mean += (interval - this.#mean) / Math.min(this.#frames, PATIENCE);
    if (this.#frames < PATIENCE) return;
    const step = this.#mean > SLOW ? 1 : this.#mean < FAST ? -1 : 0;
    const level = Math.min(LEVELS.length - 1, Math.max(0, this.#level + step));
    if (level === this.#level) return;
    this.#level = level;
    this.#frames = 0;
  }
}
