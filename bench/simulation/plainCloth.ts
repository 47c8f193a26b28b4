import type { Springs } from '../../src/dynamics/forces/springs.ts';
import type { Vec3 } from '../../src/math/vec3.ts';

interface Point {
  place: Vec3;
  velocity: Vec3;
  force: Vec3;
  readonly pinned: boolean;
}

interface Spring {
  readonly a: Point;
  readonly b: Point;
  readonly k: number;
  readonly length: number;
}

/**
 * The baseline: a cloth written as in the source documents. Points and springs are objects, the state is velocities, forces become accelerations by the
 * matrix (I − ββᵀ)/γm per point, and steps are semi-implicit Euler.
 */
export class PlainCloth {
  private readonly c: number;
  private readonly mass: number;
  private readonly gravity: Vec3;
  private readonly points: readonly Point[];
  private readonly springs: readonly Spring[];

  constructor(x: Float64Array, pinned: Uint8Array, springs: Springs, mass: number, gravity: Vec3, c: number) {
    this.c = c;
    this.mass = mass;
    this.gravity = gravity;
    this.points = Array.from(pinned, (held, i) => ({
      place: [x[3 * i], x[3 * i + 1], x[3 * i + 2]],
      velocity: [0, 0, 0],
      force: [0, 0, 0],
      pinned: held === 1,
    }));
    this.springs = Array.from(springs.lengths, (length, s) => ({
      a: this.points[springs.ends[2 * s]],
      b: this.points[springs.ends[2 * s + 1]],
      k: springs.stiffness[s],
      length,
    }));
  }

  step(h: number): void {
    const { mass, gravity } = this;
    for (const point of this.points) point.force = [mass * gravity[0], mass * gravity[1], mass * gravity[2]];
    for (const { a, b, k, length } of this.springs) {
      const d = minus(b.place, a.place);
      const distance = Math.hypot(...d);
      const pull = times(d, (k * (distance - length)) / distance);
      a.force = plus(a.force, pull);
      b.force = minus(b.force, pull);
    }
    for (const point of this.points) {
      if (point.pinned) continue;
      point.velocity = plus(point.velocity, times(this.acceleration(point), h));
      point.place = plus(point.place, times(point.velocity, h));
    }
  }

  /** (I − ββᵀ) F/γm */
  private acceleration({ velocity, force }: Point): Vec3 {
    const beta = times(velocity, 1 / this.c);
    const gamma = 1 / Math.sqrt(1 - beta[0] ** 2 - beta[1] ** 2 - beta[2] ** 2);
    const matrix = [0, 1, 2].map((row) => [0, 1, 2].map((k) => (row === k ? 1 : 0) - beta[row] * beta[k]));
    const a = matrix.map((row) => (row[0] * force[0] + row[1] * force[1] + row[2] * force[2]) / (gamma * this.mass));
    return [a[0], a[1], a[2]];
  }
}

const plus = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a: Vec3, s: number): Vec3 => [s * a[0], s * a[1], s * a[2]];
