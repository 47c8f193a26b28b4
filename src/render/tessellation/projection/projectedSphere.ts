import type { Mat4 } from '../../../math/mat4.ts';
import { CAMERA_PLANE_COSINE } from '../criterion/edgeCriterion.ts';
import type { ScreenMetric } from '../criterion/tessellationView.ts';

/**
 * What can be said of all that is seen in a ball at once. L, the matrix of a boost and perhaps a rotation, takes (|X|, X) to (|Δx′|, Δx′), and so the
 * cone that the ball is seen in, as (cosine, axis), to the cone it is shown in (culling.ts). The numbers grow with the ball.
 */
export class ProjectedSphere {
  private readonly L: Mat4;
  private readonly metric: ScreenMetric;
  private readonly w: number;
  /** Distance of the ball from the observer [m]; what follows has a meaning where it is above 0. */
  minDistance = 0;
  /** Most and least of D = |Δx′|/|X| = γ + u·n. */
  maxStretch = 1;
  minStretch = 1;
  /** Most of the sine of the angle between Δx′ and the way the observer moves. */
  maxSine = 1;
  /** Most of 1 + tan²θ, at most that of the picture's corner. */
  maxMagnification = 1;
  /** It may be shown near the plane across the line of sight (edgeCriterion.ts). */
  nearCameraPlane = true;
  /** The cone it is shown in: unit axis, sine and cosine of half its opening. */
  private ax = 0;
  private ay = 0;
  private az = 0;
  private sineRadius = 0;
  private cosineRadius = 1;

  constructor(L: Mat4, gauge: ScreenMetric) {
    this.L = L;
    this.metric = gauge;
    this.w = Math.sqrt(L[1] * L[1] + L[2] * L[2] + L[3] * L[3]);
  }

  /** Chooses the ball round X [m]. */
  set(x: number, y: number, z: number, radius: number): void {
    const { L } = this;
    const far = Math.sqrt(x * x + y * y + z * z);
    this.minDistance = far - radius;
    if (!(this.minDistance > 0)) return;
    const sine = radius / far;
    const k = Math.sqrt(1 - sine * sine);
    const ax = L[4] * k + (L[5] * x + L[6] * y + L[7] * z) / far;
    const ay = L[8] * k + (L[9] * x + L[10] * y + L[11] * z) / far;
    const az = L[12] * k + (L[13] * x + L[14] * y + L[15] * z) / far;
    const along = (L[1] * x + L[2] * y + L[3] * z) / far;
    // Not unit yet: |axis|² − cosine² is the invariant 1 − k².
    const size = Math.sqrt(ax * ax + ay * ay + az * az);
    this.ax = ax / size;
    this.ay = ay / size;
    this.az = az / size;
    this.sineRadius = sine / size;
    this.cosineRadius = (L[0] * k + along) / size;
    this.computeStretch(along, sine);
  }

  /** No pixel can show any of it. */
  isOutside(): boolean {
    if (!(this.minDistance > 0) || this.cosineRadius <= 0) return false;
    for (const s of this.metric.sides)
      if (s[0] * this.ax + s[1] * this.ay + s[2] * this.az < -this.sineRadius - 1e-9) return true;
    return false;
  }

  /** Fills `sine`, `magnified` and `sideways`. */
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

/** The cosine of an angle plus a smaller one below π, at most π; of the first the cosine is given, of the second sine and cosine. */
function cosineOfSum(cosine: number, sine: number, k: number): number {
  return cosine <= -k ? -1 : cosine * k - Math.sqrt(Math.max(0, 1 - cosine * cosine)) * sine;
}
