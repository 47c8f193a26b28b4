/** What is asked of the yaw in a moment, to the left. */
export interface AskedYaw {
  /** By mouse or finger [rad]. */
  readonly dragged: number;
  /** By keys and stick as they are held, in units of a key. */
  readonly held: number;
}

/** A key or a stick turns from there on, … */
const ENGAGED = 0.8;
/** … and may turn again once it has been let go so far. */
const RELEASED = 0.5;
/** Who holds it turns again after that time, and a drag that rests so long is over [s]. */
const REPEAT = 0.5;

/**
 * Turns in steps instead of continuously, so that no picture is seen to turn. A key or a stick turns by one step at once, and by
 * another every half second while it is held; a drag turns by one step for each that it is long.
 */
export class SnapTurn {
  private readonly step: number;
  /** To which side a key or stick is held. */
  private side = 0;
  /** Until it turns again [s]. */
  private wait = 0;
  /** Of a drag, not turned yet [rad]. */
  private rest = 0;
  private idle = 0;

  /** `step` [rad] */
  constructor(step: number) {
    this.step = step;
  }

  /** The yaw of a moment of `dt` [s]: a whole number of steps [rad]. */
  yaw({ dragged, held }: AskedYaw, dt: number): number {
    return (this.stepsHeld(held, dt) + this.stepsDragged(dragged, dt)) * this.step;
  }

  private stepsHeld(held: number, dt: number): number {
    const before = this.side;
    if (Math.abs(held) >= ENGAGED) this.side = Math.sign(held);
    else if (Math.abs(held) < RELEASED || Math.sign(held) !== before) this.side = 0;
    this.wait -= dt;
    if (this.side === 0 || (this.side === before && this.wait > 0)) return 0;
    this.wait = REPEAT;
    return this.side;
  }

  private stepsDragged(dragged: number, dt: number): number {
    this.idle = dragged === 0 ? this.idle + dt : 0;
    if (this.idle >= REPEAT) this.rest = 0;
    this.rest += dragged;
    const steps = Math.trunc(this.rest / this.step);
    this.rest -= steps * this.step;
    return steps;
  }
}
