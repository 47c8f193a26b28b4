import { bendFactor, type CubicPointsMotion } from '../../../scene/motion/cubicPoints.ts';
import type { Observation } from '../../geometry/observation.ts';
import { SampledPointsIntersector, type SampleWindow } from './sampledIntersector.ts';

/** Newton's steps end when they are smaller than this share of the piece; a bracket that only is halved gets so narrow in as many steps. */
const RELATIVE_STEP = 1e-14;
const MAX_STEPS = 50;

/** A deforming mesh whose vertices go along cubics, and so all points between them. */
export class CubicPointsIntersector extends SampledPointsIntersector {
  private readonly velocities: readonly Float32Array[];
  /** Of the window's pieces. */
  private readonly bends: Float64Array;
  /** The piece that is looked at: a + s V + s(1 − w)² p + s w(w − 1) q, w = s/span, V the chord's velocity. */
  private readonly piece = {
    a: new Float64Array(3),
    V: new Float64Array(3),
    p: new Float64Array(3),
    q: new Float64Array(3),
  };
  private readonly velocity = new Float64Array(3);

  constructor(motion: CubicPointsMotion, window: SampleWindow, sight: Observation) {
    super(motion, window, sight);
    const { first, count } = window;
    this.velocities = motion.velocities.slice(first, first + count);
    this.bends = Float64Array.from({ length: count - 1 }, (_, k) => bendFactor(motion, first + k, sight.c));
  }

  /** Curves have corners where pieces have lost of their bend, and where the motion begins and ends. */
  get smooth(): boolean {
    return !this.includesStart && !this.includesEnd && !this.straightened;
  }

  protected override get straightened(): boolean {
    return this.bends.some((bend) => bend < 1);
  }

  /** The surface is crossed once: Newton's steps in a bracket, from the middle. */
  protected override intersectPiece(k: number, out: Float64Array, at: number): void {
    this.setPiece(k);
    const from = this.times[k];
    const span = this.times[k + 1] - from;
    let lo = 0;
    let hi = span;
    let s = span / 2;
    for (let i = 0; i < MAX_STEPS; i++) {
      this.evaluate(s, span);
      const late = this.lateness(from + s);
      if (late <= 0) lo = s;
      else hi = s;
      const newton = s - late / this.latenessRate();
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

  /** Place and velocity so long after the beginning of the piece. */
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

  /** How fast `late` rises along the world line. */
  private latenessRate(): number {
    const [vx, vy, vz] = this.velocity;
    return this.surface.latenessRate(this.x, this.y, this.z, vx, vy, vz, this.observation.u, this.gamma);
  }
}
