/** A frame that comes so early is in time [ms]: screens are not exact. */
const SLACK = 2;

/** Lets so many frames a second pass at most, evenly also where the screen's rate is no multiple. */
export class FrameCap {
  private due = Number.NEGATIVE_INFINITY;

  /** `now` [ms], `most` frames a second. */
  passes(now: number, most: number): boolean {
    if (now < this.due - SLACK) return false;
    const period = 1000 / most;
    // One that comes late is made up for, not those of a pause.
    this.due = Math.max(this.due, now - period) + period;
    return true;
  }
}
