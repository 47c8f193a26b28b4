import type { Vec3 } from '../math/vec3.ts';

/** Points of a lump; they are near each other where neighbours in a mesh are. */
const LUMP = 64;
/** Numbers per lump: centre, radius. */
const SIZE = 4;

/** Points, in lumps with a ball round each: how far they reach in a direction is found without a look at most of them. */
export class Extremes {
  private readonly points: ArrayLike<number>;
  private readonly balls: Float64Array;

  /** 3 finite numbers each. */
  constructor(points: ArrayLike<number>) {
    this.points = points;
    const lumps = Math.ceil(points.length / (3 * LUMP));
    this.balls = new Float64Array(SIZE * lumps);
    for (let k = 0; k < lumps; k++) this.enclose(k);
  }

  /** The greatest d · x of all points x. */
  reach([x, y, z]: Vec3): number {
    const { points, balls } = this;
    const size = Math.hypot(x, y, z);
    let most = Number.NEGATIVE_INFINITY;
    for (let k = 0; SIZE * k < balls.length; k++) {
      const b = SIZE * k;
      if (!(x * balls[b] + y * balls[b + 1] + z * balls[b + 2] + size * balls[b + 3] > most)) continue;
      const end = Math.min(points.length, 3 * LUMP * (k + 1));
      for (let i = 3 * LUMP * k; i < end; i += 3) {
        const along = x * points[i] + y * points[i + 1] + z * points[i + 2];
        if (along > most) most = along;
      }
    }
    return most;
  }

  private enclose(k: number): void {
    const { points, balls } = this;
    const end = Math.min(points.length, 3 * LUMP * (k + 1));
    const from = 3 * LUMP * k;
    const count = (end - from) / 3;
    const b = SIZE * k;
    for (let i = from; i < end; i++) balls[b + ((i - from) % 3)] += points[i] / count;
    let square = 0;
    for (let i = from; i < end; i += 3)
      square = Math.max(
        square,
        (points[i] - balls[b]) ** 2 + (points[i + 1] - balls[b + 1]) ** 2 + (points[i + 2] - balls[b + 2]) ** 2,
      );
    // Rounded up, so that no point is beyond.
    balls[b + 3] = Math.sqrt(square) * (1 + 1e-12);
  }
}
