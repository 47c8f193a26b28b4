import type { Vec3 } from '../../math/vec3.ts';

/** The largest d · x over the points x of something; −∞ without points. */
export type Support = (d: Vec3) => number;

/** Points per cluster; consecutive points of a mesh are usually close to each other. */
const CLUSTER_POINTS = 64;
/** Floats per cluster: centre and radius. */
const SPHERE_NUMBERS = 4;

/** The support function of points, accelerated by bounding spheres of clusters. */
export class SupportMap {
  private readonly points: ArrayLike<number>;
  private readonly spheres: Float64Array;

  /** `points`: 3 finite numbers each. */
  constructor(points: ArrayLike<number>) {
    this.points = points;
    const clusters = Math.ceil(points.length / (3 * CLUSTER_POINTS));
    this.spheres = new Float64Array(SPHERE_NUMBERS * clusters);
    for (let k = 0; k < clusters; k++) this.enclose(k);
  }

  /** The largest d · x over all points x. */
  support([x, y, z]: Vec3): number {
    const { points, spheres } = this;
    const size = Math.hypot(x, y, z);
    let max = Number.NEGATIVE_INFINITY;
    for (let k = 0; SPHERE_NUMBERS * k < spheres.length; k++) {
      const b = SPHERE_NUMBERS * k;
      if (!(x * spheres[b] + y * spheres[b + 1] + z * spheres[b + 2] + size * spheres[b + 3] > max)) continue;
      const end = Math.min(points.length, 3 * CLUSTER_POINTS * (k + 1));
      for (let i = 3 * CLUSTER_POINTS * k; i < end; i += 3) {
        const along = x * points[i] + y * points[i + 1] + z * points[i + 2];
        if (along > max) max = along;
      }
    }
    return max;
  }

  private enclose(k: number): void {
    const { points, spheres } = this;
    const end = Math.min(points.length, 3 * CLUSTER_POINTS * (k + 1));
    const from = 3 * CLUSTER_POINTS * k;
    const count = (end - from) / 3;
    const b = SPHERE_NUMBERS * k;
    for (let i = from; i < end; i++) spheres[b + ((i - from) % 3)] += points[i] / count;
    let square = 0;
    for (let i = from; i < end; i += 3)
      square = Math.max(
        square,
        (points[i] - spheres[b]) ** 2 + (points[i + 1] - spheres[b + 1]) ** 2 + (points[i + 2] - spheres[b + 2]) ** 2,
      );
    // Rounded up, so that no point is outside.
    spheres[b + 3] = Math.sqrt(square) * (1 + 1e-12);
  }
}
