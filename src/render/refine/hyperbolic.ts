import { add, dot, length, type Vec3 } from '../../math/vec3.ts';
import type { WorldLine } from '../../physics/worldLine.ts';
import type { HyperbolicMotion } from '../../scene/types.ts';
import { lineOfCentre, type MovingBody } from '../bodies.ts';
import { meet, type Sight, type Span, spanOf, trailingPoint } from '../sight.ts';
import type { Mover, Reach } from './moving.ts';
import type { Lump } from './shown.ts';

/** A body in hyperbolic motion: each point has its own world line; behind its horizon it is not seen. */
export class Hyperbolic implements Mover {
  private readonly body: MovingBody;
  private readonly motion: HyperbolicMotion;
  private readonly positions: Float32Array;
  private readonly sight: Sight;
  private corners: readonly [number, number, number] = [0, 0, 0];

  constructor(body: MovingBody, motion: HyperbolicMotion, positions: Float32Array, sight: Sight) {
    this.body = body;
    this.motion = motion;
    this.positions = positions;
    this.sight = sight;
  }

  take(a: number, b: number, c: number): void {
    this.corners = [3 * a, 3 * b, 3 * c];
  }

  meet(w1: number, w2: number, out: Float64Array, at: number): void {
    const [p, [a, b, c]] = [this.positions, this.corners];
    const w0 = 1 - w1 - w2;
    const blend = (k: number) => w0 * p[a + k] + w1 * p[b + k] + w2 * p[c + k];
    const seen = meet(this.lineAt([blend(0), blend(1), blend(2)]), this.sight);
    for (let k = 0; k < 3; k++) out[at + k] = seen ? seen.offset[k] : Number.NaN;
  }

  reach({ x, y, z, radius }: Lump): Reach {
    const centre: Vec3 = [x, y, z];
    const span = spanOf(this.lineAt(centre), radius, this.sight);
    if (!span) return { centre: [0, 0, 0], radius: Number.POSITIVE_INFINITY, speed: 1, shear: 2, rate: 0, jolt: never };
    // What trails is driven hardest, where the body is Born rigid.
    const trailing = this.lineAt(add(centre, trailingPoint(this.motion.properAcceleration, radius)));
    return { ...span.ball, speed: this.fastest(trailing, span), shear: 2, rate: 0, jolt: never };
  }

  private lineAt(offset: Vec3): WorldLine {
    return lineOfCentre(this.body, this.sight.c, offset);
  }

  /** v = κτ/√(1 + κ²τ²), κ = a/c², τ: time since the turning point [m of light]. */
  private fastest(line: WorldLine, { from, to }: Span): number {
    const { motion, sight } = this;
    if (line.kind !== 'hyperbolic') return 0;
    const a = line.properAcceleration;
    // Beyond the body's own horizon nothing can be rigid.
    if (dot(a, motion.properAcceleration) < 0 || !Number.isFinite(length(a))) return 1;
    const since = sight.c * (sight.t - line.t0);
    const turned = (length(a) / (sight.c * sight.c)) * Math.max(Math.abs(from + since), Math.abs(to + since));
    return turned / Math.hypot(1, turned);
  }
}

/** Its velocity changes too smoothly to be bounded by jolts: edges that are not short are looked at. */
const never = (): number => Number.POSITIVE_INFINITY;
