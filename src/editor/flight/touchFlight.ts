import type { Vec3 } from '../../math/vec3.ts';

/** How far two fingers move for full thrust [px]. */
const FULL_THRUST = 90;

/** Fingers on the picture: one looks around, two fly as a stick does, by how far they have moved since the second came. */
export class TouchFlight {
  private readonly fingers = new Map<number, readonly [x: number, y: number]>();
  private from: readonly [x: number, y: number] = [0, 0];
  private roll = 0;

  down(id: number, x: number, y: number): void {
    this.fingers.set(id, [x, y]);
    this.from = this.middle();
  }

  /** How far a single finger has moved [px]; 0 while there are more, or for a finger that is not down. */
  move(id: number, x: number, y: number): readonly [dx: number, dy: number] {
    const before = this.fingers.get(id);
    if (!before) return [0, 0];
    const twist = this.direction();
    this.fingers.set(id, [x, y]);
    if (this.fingers.size === 2) this.roll += wrapped(twist - this.direction());
    return this.fingers.size === 1 ? [x - before[0], y - before[1]] : [0, 0];
  }

  up(id: number): void {
    this.fingers.delete(id);
    this.from = this.middle();
  }

  /** How far two fingers have twisted since the last call [rad], anticlockwise as roll is. */
  takeRoll(): number {
    const { roll } = this;
    this.roll = 0;
    return roll;
  }

  /** In camera axes, of length 1 at most: fingers that move up accelerate forwards, three up and down. */
  thrust(): Vec3 {
    if (this.fingers.size < 2) return [0, 0, 0];
    const [x, y] = this.middle();
    const [right, back] = [(x - this.from[0]) / FULL_THRUST, (y - this.from[1]) / FULL_THRUST];
    const size = Math.max(1, Math.hypot(right, back));
    return this.fingers.size > 2 ? [right / size, -back / size, 0] : [right / size, 0, back / size];
  }

  /** From the first finger to the second [rad], clockwise as y is down. */
  private direction(): number {
    const [a = [0, 0], b = [0, 0]] = this.fingers.values();
    return Math.atan2(b[1] - a[1], b[0] - a[0]);
  }

  private middle(): readonly [x: number, y: number] {
    const places = [...this.fingers.values()];
    const mean = (k: 0 | 1): number => places.reduce((sum, place) => sum + place[k], 0) / Math.max(1, places.length);
    return [mean(0), mean(1)];
  }
}

/** An angle between −π and π. */
const wrapped = (angle: number): number => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
