/** Fewer pixels while the picture moves and frames are slow, all of them as soon as it rests: a slow machine stays flyable. */

interface QualityLevel {
  /** Of the pixels' number along each side, 0 … 1. */
  readonly scale: number;
  /** With what makes a picture more beautiful, and changes nothing in it. */
  readonly fullQuality: boolean;
}

/** Each takes about half as long as the one before. */
const QUALITY_LEVELS: readonly QualityLevel[] = [
  { scale: 1, fullQuality: true },
  { scale: 0.7, fullQuality: true },
  { scale: 0.7, fullQuality: false },
  { scale: 0.5, fullQuality: false },
];
/** Frames that take longer [ms] ask for fewer pixels, and shorter ones allow more. */
const SLOW_FRAME = 70;
const FAST_FRAME = 22;
/** So long without a change [ms], and the picture rests. */
const STILL_AFTER = 250;
/** Frames between two changes of level, so that each is judged by its own frames. */
const FRAMES_PER_DECISION = 6;

export class DynamicResolution {
  /** The level that motion needs on this machine; kept over rests. */
  private level = 0;
  private moving = false;
  private lastChange = Number.NEGATIVE_INFINITY;
  private frames = 0;
  private mean = 0;

  get scale(): number {
    return this.shown.scale;
  }

  get fullQuality(): boolean {
    return this.shown.fullQuality;
  }

  get isStill(): boolean {
    return !this.moving;
  }

  private get shown(): QualityLevel {
    return QUALITY_LEVELS[this.moving ? this.level : 0]!;
  }

  /** After each frame: whether what is to be seen changed, the time now and since the frame before [ms]. */
  recordFrame(changed: boolean, now: number, interval: number): void {
    if (!changed) {
      if (now - this.lastChange > STILL_AFTER) this.moving = false;
      return;
    }
    // The first frames of a motion also carry what the rest before them cost.
    if (this.moving) this.judge(interval);
    this.moving = true;
    this.lastChange = now;
  }

  private judge(interval: number): void {
    this.frames++;
    this.mean += (interval - this.mean) / Math.min(this.frames, FRAMES_PER_DECISION);
    if (this.frames < FRAMES_PER_DECISION) return;
    const step = this.mean > SLOW_FRAME ? 1 : this.mean < FAST_FRAME ? -1 : 0;
    const level = Math.min(QUALITY_LEVELS.length - 1, Math.max(0, this.level + step));
    if (level === this.level) return;
    this.level = level;
    this.frames = 0;
  }
}
