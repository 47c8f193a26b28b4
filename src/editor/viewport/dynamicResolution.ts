/** Dynamic resolution: fewer pixels while the picture moves and frames are slow, all of them at rest. */

interface QualityLevel {
  /** Scale of width and height, 0 … 1. */
  readonly scale: number;
  /** Whether costly visual effects are on. */
  readonly fullQuality: boolean;
}

/** Each takes about half the time of the previous. */
const QUALITY_LEVELS: readonly QualityLevel[] = [
  { scale: 1, fullQuality: true },
  { scale: 0.7, fullQuality: true },
  { scale: 0.7, fullQuality: false },
  { scale: 0.5, fullQuality: false },
];
/** Frame times above this lower the resolution, and those below the other raise it [ms]. */
const SLOW_FRAME = 70;
const FAST_FRAME = 22;
/** Time without change after which the picture counts as still [ms]. */
const STILL_AFTER = 250;
/** Frames between two decisions, so that each level is judged by its own frames. */
const FRAMES_PER_DECISION = 6;

export class DynamicResolution {
  /** Level for moving pictures; kept while at rest. */
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

  /** Call after each frame: whether the picture changed, the current time and the frame time [ms]. */
  recordFrame(changed: boolean, now: number, interval: number): void {
    if (!changed) {
      if (now - this.lastChange > STILL_AFTER) this.moving = false;
      return;
    }
    // The first frames of a motion include work from the rest before.
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
