import type { Mat4 } from '../../math/mat4.ts';
import { IDENTITY } from '../../math/mat4.ts';
import { negate, type Vec3 } from '../../math/vec3.ts';
import { boostMatrix, gamma } from '../../physics/boost.ts';
import { ShownBall } from './bounds.ts';
import { GRADE, GRADE_SIDEWAYS } from './criterion.ts';
import type { Gauge } from './look.ts';
import { DRAWN, type Fate, type Lump, OUTSIDE, REFINED, SHORTEST, SHORTEST_KINKED, type Shown } from './shown.ts';

/** Where the points of a body that changes its velocity are, on the surface that a picture is made of. */
export interface Mover {
  /** Chooses a triangle, by its vertices' places in the batch. */
  take(a: number, b: number, c: number): void;
  /** Observer → event [m] of the point with these weights of the triangle's second and third corner, to `out[at …]`; NaN where there is none. */
  meet(w1: number, w2: number, out: Float64Array, at: number): void;
  /** What holds all events of a lump. */
  reach(lump: Lump): Reach;
}

/** A ball relative to the observer's event, world frame [m], and how what is in it moves, in units of c. */
export interface Reach {
  readonly centre: Vec3;
  readonly radius: number;
  /** The fastest. */
  readonly speed: number;
  /** The most by which the velocities of an edge's ends can differ at one time. */
  readonly shear: number;
  /** How fast velocities change between sudden changes, at most [1/m of light]. */
  readonly rate: number;
  /** The most by which a velocity can change suddenly within so much time [m of light], all changes added. */
  readonly jolt: (time: number) => number;
}

/** Bodies whose points have no common frame: their edges are looked at by their events alone. */
export class Moving implements Shown {
  readonly kinked: boolean;
  private readonly mover: Mover;
  private readonly gauge: Gauge;
  /** From (|Δx|, Δx) to (|Δx′|, Δx′). */
  private readonly L: Mat4;
  private readonly ball: ShownBall;
  /** Shown contracted: Δx′ = Δx − u (u·Δx)/(γ(γ + 1)). */
  private readonly squeeze: number;

  constructor(mover: Mover, kinked: boolean, gauge: Gauge) {
    const { sight, projection } = gauge.look;
    const g = gamma(sight.u);
    this.mover = mover;
    this.kinked = kinked;
    this.gauge = gauge;
    this.L = projection.place === 'apparent' ? boostMatrix(negate(sight.u)) : IDENTITY;
    this.ball = new ShownBall(this.L, gauge);
    this.squeeze = projection.place === 'contracted' ? 1 / (g * (g + 1)) : 0;
  }

  fate(lump: Lump): Fate {
    const reach = this.mover.reach(lump);
    const { centre, radius, speed } = reach;
    if (!(radius < Number.POSITIVE_INFINITY)) return REFINED;
    const { L, gauge } = this;
    const u = gauge.look.sight.u;
    const squeezed = this.squeeze * (u[0] * centre[0] + u[1] * centre[1] + u[2] * centre[2]);
    const [x, y, z] = [centre[0] - squeezed * u[0], centre[1] - squeezed * u[1], centre[2] - squeezed * u[2]];
    const { ball } = this;
    ball.set(x, y, z, radius);
    if (ball.outside()) return OUTSIDE;
    if (!(ball.near > 0) || !(speed < 1)) return REFINED;
    ball.look();
    const longest = lump.longest / (1 - speed);
    const image = longest * Math.sqrt(2 * L[0] * ball.mostStretched);
    const scale = (gauge.look.focal * ball.magnified) / (ball.leastStretched * ball.near);
    if (image * scale < (this.kinked ? SHORTEST_KINKED : SHORTEST)) return DRAWN;
    const grade = ball.sideways ? GRADE_SIDEWAYS : GRADE;
    const graded = image < grade * ball.leastStretched * ball.near && longest < GRADE * ball.near;
    return graded && 2 * scale * this.bend(reach, longest, ball.near) < gauge.tolerance ? DRAWN : REFINED;
  }

  /**
   * Bound of the second difference of Δx′(f) over ¼ of an edge. Events of neighbours are apart by the time in which they move too: |Δx′(f)| and |t′(f)|
   * are at most ℓ/(1 − v) for an edge ℓ long at one time. Where velocities v(f) are constant, Δx″ = 2v′t′ + v t″ (and a t′² where they change by a), and |t″| ≤ |Δx′|²/|Δx| + |Δx″| on the
   * light cone; where one changes by J, Δx′ jumps by at most J|t′|/(1 − v). The boost takes Δx to MΔx + |Δx|m with |M| = γ, |m| = γβ.
   */
  private bend({ speed, shear, rate, jolt }: Reach, longest: number, near: number): number {
    const jump = (jolt(longest) * longest) / (1 - speed);
    const curve = (2 * shear * longest + (rate + speed / near) * longest * longest) / (1 - speed);
    const delay = (longest * longest) / near + curve;
    const w = Math.hypot(this.L[1], this.L[2], this.L[3]);
    return this.L[0] * (curve / 16 + jump / 4) + w * (delay / 16 + jump / 4);
  }

  take(a: number, b: number, c: number): void {
    this.mover.take(a, b, c);
  }

  turnedAway(): boolean {
    return false;
  }

  point(out: Float64Array, at: number): void {
    const { L } = this;
    const { u } = this.gauge.look.sight;
    this.mover.meet(out[at + 6], out[at + 7], out, at + 3);
    const x = out[at + 3];
    const y = out[at + 4];
    const z = out[at + 5];
    const r = Math.sqrt(x * x + y * y + z * z);
    const squeezed = this.squeeze * (u[0] * x + u[1] * y + u[2] * z);
    out[at] = L[4] * r + L[5] * x + L[6] * y + L[7] * z - squeezed * u[0];
    out[at + 1] = L[8] * r + L[9] * x + L[10] * y + L[11] * z - squeezed * u[1];
    out[at + 2] = L[12] * r + L[13] * x + L[14] * y + L[15] * z - squeezed * u[2];
  }

  /** Between graded edges the surface stays well within twice its corners' distance from their middle. */
  outside(points: Float64Array, a: number, b: number, c: number): boolean {
    const x = (points[a] + points[b] + points[c]) / 3;
    const y = (points[a + 1] + points[b + 1] + points[c + 1]) / 3;
    const z = (points[a + 2] + points[b + 2] + points[c + 2]) / 3;
    const radius = 2 * Math.max(apart(points, a, x, y, z), apart(points, b, x, y, z), apart(points, c, x, y, z));
    for (const s of this.gauge.sides) if (s[0] * x + s[1] * y + s[2] * z < -radius) return true;
    return false;
  }

  surelyOutside(): boolean {
    return false;
  }

  calm(): boolean {
    return false;
  }
}

function apart(points: Float64Array, i: number, x: number, y: number, z: number): number {
  const dx = points[i] - x;
  const dy = points[i + 1] - y;
  const dz = points[i + 2] - z;
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}
