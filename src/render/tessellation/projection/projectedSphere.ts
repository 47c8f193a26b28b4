import type { Mat4 } from '../../../math/mat4.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import { CAMERA_PLANE_COSINE } from '../criterion/edgeCriterion.ts';
import type { ScreenMetric } from '../criterion/tessellationView.ts';

/**
 * Bounds for everything that is seen in a sphere, also by a camera that has stepped aside. L, the matrix of a boost and perhaps a rotation, maps (|X|, X) to (|Δx′|, Δx′), and so it maps the cone in
 * which the sphere is seen, as (cosine, axis), to the cone in which it appears (docs/physics.md §3.6). From elsewhere the image is in a sphere about that of
 * its centre, larger by the most that L lengthens what is in it. The bounds grow with the sphere.
 */
export class ProjectedSphere {
  private readonly L: Mat4;
  private readonly metric: ScreenMetric;
  private readonly w: number;
  /** Least distance at which it may appear from the camera [m]; the other values are valid only if it is above 0. */
  nearest = 0;
  /** Distance of the sphere from the observer [m]. */
  minDistance = 0;
  /** Largest and least D = |Δx′|/|X| = γ + u·n. */
  maxStretch = 1;
  minStretch = 1;
  /** Largest sine of the angle between the line of sight and the observer's velocity. */
  maxSine = 1;
  /** Largest 1 + tan²θ, at most that of the picture's corner. */
  maxMagnification = 1;
  /** Whether part of the sphere may appear near the plane across the line of sight (edgeCriterion.ts). */
  nearCameraPlane = true;
  /** The cone in which the sphere appears to the camera: unit axis, sine and cosine of its half angle. */
  private ax = 0;
  private ay = 0;
  private az = 0;
  private sineRadius = 0;
  private cosineRadius = 1;

  constructor(L: Mat4, metric: ScreenMetric) {
    this.L = L;
    this.metric = metric;
    this.w = Math.sqrt(L[1] * L[1] + L[2] * L[2] + L[3] * L[3]);
  }

  /** Sets the sphere, with centre X [m]. */
  set(x: number, y: number, z: number, radius: number): void {
    const { L } = this;
    const distance = Math.sqrt(x * x + y * y + z * z);
    this.minDistance = distance - radius;
    this.nearest = this.minDistance;
    if (!(this.minDistance > 0)) return;
    const sine = radius / distance;
    const k = Math.sqrt(1 - sine * sine);
    const ax = L[4] * k + (L[5] * x + L[6] * y + L[7] * z) / distance;
    const ay = L[8] * k + (L[9] * x + L[10] * y + L[11] * z) / distance;
    const az = L[12] * k + (L[13] * x + L[14] * y + L[15] * z) / distance;
    const along = (L[1] * x + L[2] * y + L[3] * z) / distance;
    // Not normalized yet: |axis|² − cosine² is the invariant 1 − k².
    const size = Math.sqrt(ax * ax + ay * ay + az * az);
    this.ax = ax / size;
    this.ay = ay / size;
    this.az = az / size;
    this.sineRadius = sine / size;
    this.cosineRadius = (L[0] * k + along) / size;
    this.computeStretch(along, sine);
    this.nearest = this.minStretch * this.minDistance;
    if (this.metric.view.vantage) this.lookFrom(this.metric.view.vantage, x, y, z, radius);
  }

  /** The cone in which the image of the sphere appears from elsewhere. */
  private lookFrom(from: Vec3, x: number, y: number, z: number, radius: number): void {
    const { L } = this;
    const r = Math.sqrt(x * x + y * y + z * z);
    const px = L[4] * r + L[5] * x + L[6] * y + L[7] * z - from[0];
    const py = L[8] * r + L[9] * x + L[10] * y + L[11] * z - from[1];
    const pz = L[12] * r + L[13] * x + L[14] * y + L[15] * z - from[2];
    const distance = Math.sqrt(px * px + py * py + pz * pz);
    const imageRadius = radius * Math.sqrt(2 * L[0] * this.maxStretch);
    this.nearest = distance - imageRadius;
    if (!(this.nearest > 0)) return;
    this.ax = px / distance;
    this.ay = py / distance;
    this.az = pz / distance;
    this.sineRadius = imageRadius / distance;
    this.cosineRadius = Math.sqrt(1 - this.sineRadius * this.sineRadius);
  }

  /** Whether no pixel can show any of it. */
  isOutside(): boolean {
    if (!(this.nearest > 0) || this.cosineRadius <= 0) return false;
    for (const s of this.metric.sides)
      if (s[0] * this.ax + s[1] * this.ay + s[2] * this.az < -this.sineRadius - 1e-9) return true;
    return false;
  }

  /** Computes `maxSine`, `maxMagnification` and `nearCameraPlane`. */
  computeAngles(): void {
    const { L, w } = this;
    const [fx, fy, fz] = this.metric.forward;
    const { cornerMagnification } = this.metric;
    const middle = fx * this.ax + fy * this.ay + fz * this.az;
    const aside = cosineOfSum(middle, this.sineRadius, this.cosineRadius);
    this.maxMagnification = aside > 0 ? Math.min(cornerMagnification, 1 / (aside * aside)) : cornerMagnification;
    this.nearCameraPlane =
      aside < CAMERA_PLANE_COSINE && cosineOfSum(-middle, this.sineRadius, this.cosineRadius) < CAMERA_PLANE_COSINE;
    const ahead = w > 0 ? (L[4] * this.ax + L[8] * this.ay + L[12] * this.az) / w : 0;
    const from = -cosineOfSum(-ahead, this.sineRadius, this.cosineRadius);
    const to = cosineOfSum(ahead, this.sineRadius, this.cosineRadius);
    this.maxSine = from > 0 && to < 0 ? 1 : Math.sqrt(Math.max(0, 1 - Math.min(from * from, to * to)));
  }

  private computeStretch(along: number, sine: number): void {
    const { L, w } = this;
    const k = Math.sqrt(1 - sine * sine);
    const forward = w > 0 ? along / w : 0;
    this.minStretch = 1 / (L[0] + w) + w * (1 + cosineOfSum(forward, sine, k));
    this.maxStretch = L[0] - w * cosineOfSum(-forward, sine, k);
  }
}

/** The cosine of the sum of two angles, at most π; given the cosine of the first, and sine and cosine of the second, smaller one. */
function cosineOfSum(cosine: number, sine: number, k: number): number {
  return cosine <= -k ? -1 : cosine * k - Math.sqrt(Math.max(0, 1 - cosine * cosine)) * sine;
}
