import { toMatrix } from '../../math/quat.ts';
import { add, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { gamma } from '../../physics/boost.ts';
import type { PolylineLine } from '../../physics/worldLine.ts';
import { samplePose } from '../../scene/motion.ts';
import type { SampledMotion, SampledPointsMotion } from '../../scene/types.ts';
import type { Sight } from '../sight.ts';
import type { Mover, Reach } from './moving.ts';
import type { Lump } from './shown.ts';

/** Samples [first, first + count) of a motion, those that a picture needs. */
export interface Window {
  readonly first: number;
  readonly count: number;
}

/** Points that go straight from sample to sample, and rest before the first and after the last one. */
abstract class Polyline implements Mover {
  protected readonly sight: Sight;
  /** Of the window's samples after the observer's event [m of light]. */
  protected readonly times: Float64Array;
  /** Where `sample` leaves the point [m]: observer → sample, world frame. */
  protected x = 0;
  protected y = 0;
  protected z = 0;
  private readonly gamma: number;

  constructor(times: Float64Array, { first, count }: Window, sight: Sight) {
    this.sight = sight;
    this.times = times.slice(first, first + count).map((t) => sight.c * (t - sight.t));
    this.gamma = gamma(sight.u);
  }

  abstract take(a: number, b: number, c: number): void;
  abstract reach(lump: Lump): Reach;
  /** Chooses a point of the triangle. */
  protected abstract aim(w1: number, w2: number): void;
  /** Puts the place of the point at sample k of the window into x, y, z. */
  protected abstract sample(k: number): void;

  /** The surface is crossed once, since nothing is as fast as light: bisection finds the piece, a quadratic or linear equation the event in it. */
  meet(w1: number, w2: number, out: Float64Array, at: number): void {
    this.aim(w1, w2);
    let [lo, hi] = [0, this.times.length];
    while (lo < hi) {
      const mid = (lo + hi) >>> 1;
      this.sample(mid);
      if (this.late(this.times[mid]) <= 0) lo = mid + 1;
      else hi = mid;
    }
    this.sample(Math.max(0, lo - 1));
    const [ax, ay, az] = [this.x, this.y, this.z];
    out[at] = ax;
    out[at + 1] = ay;
    out[at + 2] = az;
    if (lo === 0 || lo === this.times.length) return;
    this.sample(lo);
    const span = this.times[lo] - this.times[lo - 1];
    const [vx, vy, vz] = [(this.x - ax) / span, (this.y - ay) / span, (this.z - az) / span];
    const s = Math.min(span, Math.max(0, this.crossing(-this.times[lo - 1], ax, ay, az, vx, vy, vz)));
    out[at] = ax + vx * s;
    out[at + 1] = ay + vy * s;
    out[at + 2] = az + vz * s;
  }

  /** How far behind the surface the event (x, t) is; it rises along every world line. */
  private late(t: number): number {
    const { x, y, z } = this;
    const [u0, u1, u2] = this.sight.u;
    if (this.sight.surface === 'past-light-cone') return Math.sqrt(x * x + y * y + z * z) + t;
    return this.sight.surface === 'slice' ? this.gamma * t - (u0 * x + u1 * y + u2 * z) : t;
  }

  /** Time [m of light] from A, T before the observer's, to the crossing, with velocity v: `timeSince` of physics/emission.ts, `uniformSlice`. */
  private crossing(T: number, ax: number, ay: number, az: number, vx: number, vy: number, vz: number): number {
    const [u0, u1, u2] = this.sight.u;
    if (this.sight.surface === 'now') return T;
    if (this.sight.surface === 'slice')
      return (u0 * ax + u1 * ay + u2 * az + this.gamma * T) / (this.gamma - (u0 * vx + u1 * vy + u2 * vz));
    const [nx, ny, nz] = [ax + vx * T, ay + vy * T, az + vz * T];
    const slow = 1 - (vx * vx + vy * vy + vz * vz);
    const away = nx * vx + ny * vy + nz * vz;
    const now = nx * nx + ny * ny + nz * nz;
    const root = Math.sqrt(Math.max(0, away * away + slow * now));
    if (away > 0) return T - now / (away + root);
    const g = T + ax * vx + ay * vy + az * vz;
    const r = Math.sqrt(ax * ax + ay * ay + az * az);
    return g > 0 ? ((T - r) * (T + r)) / (g + root) : (g - root) / slow;
  }
}

/** A rigid body: per sample its centre and how it is turned. */
export class Posed extends Polyline {
  private readonly positions: Float32Array;
  private readonly centres: Float64Array;
  private readonly turns: Float64Array;
  private readonly corners = new Float64Array(9);
  private px = 0;
  private py = 0;
  private pz = 0;

  /** `line`: of the body's centre. */
  constructor(motion: SampledMotion, line: PolylineLine, window: Window, positions: Float32Array, sight: Sight) {
    super(motion.times, window, sight);
    const { first, count } = window;
    this.positions = positions;
    this.centres = line.positions.slice(3 * first, 3 * (first + count)).map((x, i) => x - sight.position[i % 3]);
    this.turns = new Float64Array(9 * count);
    for (let k = 0; k < count; k++) this.turns.set(toMatrix(samplePose(motion.poses, first + k).orientation), 9 * k);
  }

  take(a: number, b: number, c: number): void {
    const p = this.positions;
    for (let k = 0; k < 3; k++) {
      this.corners[k] = p[3 * a + k];
      this.corners[3 + k] = p[3 * b + k];
      this.corners[6 + k] = p[3 * c + k];
    }
  }

  reach({ x, y, z, radius }: Lump): Reach {
    const places: Vec3[] = [];
    let speed = 0;
    for (let k = 0; k < this.times.length; k++) {
      this.turn(k, x, y, z);
      places.push([this.x, this.y, this.z]);
      if (k === 0) continue;
      const moved = length(sub(places[k], places[k - 1])) + radius * this.turned(k);
      speed = Math.max(speed, moved / (this.times[k] - this.times[k - 1]));
    }
    return { ...ballAround(places, radius), speed };
  }

  protected aim(w1: number, w2: number): void {
    const p = this.corners;
    const w0 = 1 - w1 - w2;
    this.px = w0 * p[0] + w1 * p[3] + w2 * p[6];
    this.py = w0 * p[1] + w1 * p[4] + w2 * p[7];
    this.pz = w0 * p[2] + w1 * p[5] + w2 * p[8];
  }

  protected sample(k: number): void {
    this.turn(k, this.px, this.py, this.pz);
  }

  private turn(k: number, px: number, py: number, pz: number): void {
    const [R, i] = [this.turns, 9 * k];
    this.x = R[i] * px + R[i + 1] * py + R[i + 2] * pz + this.centres[3 * k];
    this.y = R[i + 3] * px + R[i + 4] * py + R[i + 5] * pz + this.centres[3 * k + 1];
    this.z = R[i + 6] * px + R[i + 7] * py + R[i + 8] * pz + this.centres[3 * k + 2];
  }

  /** At most so far does a point at distance 1 move by the turn that ends with sample k: the Frobenius norm. */
  private turned(k: number): number {
    let sum = 0;
    for (let i = 0; i < 9; i++) sum += (this.turns[9 * k + i] - this.turns[9 * k - 9 + i]) ** 2;
    return Math.sqrt(sum);
  }
}

/** A deforming mesh: every vertex has its own samples. A lump is measured from the motion's origin, over the same window. */
export class Deforming extends Polyline {
  private readonly points: readonly Float32Array[];
  private readonly origin: Vec3;
  private corners: readonly [number, number, number] = [0, 0, 0];
  private w1 = 0;
  private w2 = 0;

  constructor(motion: SampledPointsMotion, window: Window, sight: Sight) {
    super(motion.times, window, sight);
    this.points = motion.points.slice(window.first, window.first + window.count);
    this.origin = sub(motion.origin, sight.position);
  }

  take(a: number, b: number, c: number): void {
    this.corners = [3 * a, 3 * b, 3 * c];
  }

  reach({ x, y, z, radius, speed }: Lump): Reach {
    return { centre: add(this.origin, [x, y, z]), radius, speed: speed / this.sight.c };
  }

  protected aim(w1: number, w2: number): void {
    this.w1 = w1;
    this.w2 = w2;
  }

  protected sample(k: number): void {
    const [p, o] = [this.points[k], this.origin];
    const [a, b, c] = this.corners;
    const { w1, w2 } = this;
    const w0 = 1 - w1 - w2;
    this.x = w0 * p[a] + w1 * p[b] + w2 * p[c] + o[0];
    this.y = w0 * p[a + 1] + w1 * p[b + 1] + w2 * p[c + 1] + o[1];
    this.z = w0 * p[a + 2] + w1 * p[b + 2] + w2 * p[c + 2] + o[2];
  }
}

function ballAround(places: readonly Vec3[], radius: number): { centre: Vec3; radius: number } {
  const middle = scale(add(places[0], places[places.length - 1]), 0.5);
  return { centre: middle, radius: radius + Math.max(...places.map((p) => length(sub(p, middle)))) };
}
