import { bendFactor, type CubicPointsMotion } from '../../../scene/motion/cubicPoints.ts';
import type { Observation } from '../../geometry/observation.ts';
import { SampledPointsIntersector, type SampleWindow } from './sampledIntersector.ts';

/** Newton's steps end when they are smaller than this fraction of the piece; bisection alone reaches this width in as many steps. */
const RELATIVE_STEP = 1e-14;
const MAX_STEPS = 50;

/** A deforming mesh whose vertices move along cubics, and so do all points between them. */
export class CubicPointsIntersector extends SampledPointsIntersector {
  private readonly velocities: readonly Float32Array[];
  /** Bend factors of the window's pieces. */
  private readonly bends: Float64Array;
  /** The current piece: a + s V + s(1 − w)² p + s w(w − 1) q, w = s/span, V the chord's velocity (docs/physics.md §4.8). */
  private readonly piece = {
    a: new Float64Array(3),
    V: new Float64Array(3),
    p: new Float64Array(3),
    q: new Float64Array(3),
  };
  private readonly velocity = new Float64Array(3);

  constructor(motion: CubicPointsMotion, window: SampleWindow, observation: Observation) {
    super(motion, window, observation);
    const { first, count } = window;
    this.velocities = motion.velocities.slice(first, first + count);
    this.bends = Float64Array.from({ length: count - 1 }, (_, k) => bendFactor(motion, first + k, observation.c));
  }

  /** Curves have kinks where the bend of pieces is reduced, and where the motion begins and ends. */
  get smooth(): boolean {
    return !this.includesStart && !this.includesEnd && !this.isStraightened;
  }

  protected override get isStraightened(): boolean {
    return this.bends.some((bend) => bend < 1);
  }

  /** The hypersurface is crossed once: Newton's steps within a bracket, from the middle. */
  protected override intersectPiece(k: number, out: Float64Array, at: number): void {
    this.setPiece(k);
    const from = this.times[k];
    const span = this.times[k + 1] - from;
    let lo = 0;
    let hi = span;
    let s = span / 2;
    for (let i = 0; i < MAX_STEPS; i++) {
      this.evaluate(s, span);
      const lateness = this.lateness(from + s);
      if (lateness <= 0) lo = s;
      else hi = s;
      const newton = s - lateness / this.latenessRate(from + s);
      const next = newton >= lo && newton <= hi ? newton : (lo + hi) / 2;
      const step = Math.abs(next - s);
      s = next;
      if (step <= RELATIVE_STEP * span) break;
    }
    this.evaluate(s, span);
    out[at] = this.x;
    out[at + 1] = this.y;
    out[at + 2] = this.z;
  }

  private setPiece(k: number): void {
    const { a, V, p, q } = this.piece;
    this.evaluateSample(k);
    this.copyPosition(a);
    this.evaluateSample(k + 1);
    this.copyPosition(V);
    const span = this.times[k + 1] - this.times[k];
    const bend = this.bends[k];
    this.interpolate(this.velocities[k], p);
    this.interpolate(this.velocities[k + 1], q);
    for (let i = 0; i < 3; i++) {
      V[i] = (V[i] - a[i]) / span;
      p[i] = bend * (p[i] / this.observation.c - V[i]);
      q[i] = bend * (q[i] / this.observation.c - V[i]);
    }
  }

  private copyPosition(to: Float64Array): void {
    to[0] = this.x;
    to[1] = this.y;
    to[2] = this.z;
  }

  /** Sets position and velocity at the time s after the beginning of the piece. */
  private evaluate(s: number, span: number): void {
    const { a, V, p, q } = this.piece;
    const w = s / span;
    const v = 1 - w;
    const at = (i: number): number => a[i] + s * (V[i] + v * (v * p[i] - w * q[i]));
    this.x = at(0);
    this.y = at(1);
    this.z = at(2);
    for (let i = 0; i < 3; i++) this.velocity[i] = V[i] + v * (1 - 3 * w) * p[i] + w * (3 * w - 2) * q[i];
  }

  /** How fast `lateness` rises along the world line. */
  private latenessRate(t: number): number {
    const [vx, vy, vz] = this.velocity;
    return this.surface.latenessRate(this.x, this.y, this.z, t, vx, vy, vz, this.observation.u, this.gamma);
  }
}
