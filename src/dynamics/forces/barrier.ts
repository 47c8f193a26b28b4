import { type Mat3, multiply, transform, transpose } from '../../math/mat3.ts';
import { toMatrix } from '../../math/quat.ts';
import { add, addScaled, cross, dot, length, lerp, normalize, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { pointAt } from '../system.ts';
import { addBlock, type Force, type PlainBarrier, type Stiffness } from './force.ts';
import type { Obstacle } from './obstacle.ts';

/** A third is cut off so often. */
const SEARCH = 40;

/**
 * Pushes points out of an obstacle: V = Σ ½K(margin − d)² of those whose distance d is below the margin. `K` [N/m], `margin` [m]. Its discrete gradient is Gonzalez's:
 * the gradient halfway, and along the way what is missing of V₁ − V₀. `carriers`: points that are led, which the obstacle goes with: its middle, and, where it
 * turns, the ends of two arms along its own x and y; none: it stands fast. Places are then taken as it sees them, in the axes that it had at first.
 */
export const barrier = (
  obstacle: Obstacle,
  points: readonly number[],
  K: number,
  margin = 0,
  carriers: readonly number[] = [],
): Force => new Barrier({ kind: 'barrier', obstacle, points, strength: K, margin }, carriers);

/** How an obstacle lies. */
interface Seat {
  /** How far its middle has gone [m]. */
  readonly gone: Vec3;
  /** How it has turned since, and back; absent: not at all. */
  readonly turn?: Mat3;
  readonly unturn?: Mat3;
}
const FAST: Seat = { gone: ZERO };

/** Most points are far off most of the time: they are asked for their distance alone, number by number. */
class Barrier implements Force {
  readonly plain: PlainBarrier;
  private readonly carriers: readonly number[];
  /** From the world to the obstacle's own axes, as it lay at first. */
  private readonly back: Mat3;

  constructor(plain: PlainBarrier, carriers: readonly number[]) {
    this.plain = plain;
    this.carriers = carriers;
    this.back = transpose(toMatrix(plain.obstacle.orientation));
  }

  energy(x: Float64Array): number {
    const { points, strength } = this.plain;
    const seat = this.seat(x);
    let sum = 0;
    for (const i of points) sum += 0.5 * strength * this.depth(x, i, seat) ** 2;
    return sum;
  }

  add(x: Float64Array, sum: Float64Array): void {
    const { points, strength } = this.plain;
    const seat = this.seat(x);
    for (const i of points) {
      const deep = this.depth(x, i, seat);
      if (deep > 0) push(sum, i, this.out(x, i, seat), strength * deep);
    }
  }

  addMean(x0: Float64Array, x1: Float64Array, sum: Float64Array): void {
    const { points, margin, obstacle, strength: K } = this.plain;
    const [seat0, seat1, halfway] = [this.seat(x0), this.seat(x1), this.seat(x0, x1)];
    for (const i of points) {
      const far0 = this.distance(x0, i, seat0);
      const far1 = this.distance(x1, i, seat1);
      // Nobody is nearer by more than he goes.
      if (Math.min(far0, far1) >= margin && Math.max(far0, far1) - this.goes(x0, x1, i, seat0, seat1) / 2 >= margin)
        continue;
      const a = this.seen(x0, i, seat0);
      const way = sub(this.seen(x1, i, seat1), a);
      const [distance, out] = obstacle.outside(addScaled(a, way, 0.5));
      const deep = Math.max(0, margin - distance);
      const rise = 0.5 * K * (Math.max(0, margin - far1) ** 2 - Math.max(0, margin - far0) ** 2);
      const square = dot(way, way);
      push(sum, i, toWorld(out, halfway), K * deep);
      if (square > 0) push(sum, i, toWorld(way, halfway), -(rise + K * deep * dot(out, way)) / square);
    }
  }

  stiffness(x: Float64Array): Stiffness {
    const { points, strength: K } = this.plain;
    const seat = this.seat(x);
    const pressed = points.filter((i) => this.depth(x, i, seat) > 0);
    return new BarrierStiffness(pressed.map((point) => ({ point, out: this.out(x, point, seat), K })));
  }

  addRigidity(bound: Float64Array): void {
    for (const i of this.plain.points) bound[i] += this.plain.strength;
  }

  pierced(x0: Float64Array, x1: Float64Array): number | undefined {
    const { points, obstacle } = this.plain;
    // A plane has no other side.
    if (!obstacle.half) return undefined;
    const [seat0, seat1] = [this.seat(x0), this.seat(x1)];
    return points.find(
      (i) =>
        this.distance(x0, i, seat0) < this.goes(x0, x1, i, seat0, seat1) &&
        wentThrough(obstacle, this.seen(x0, i, seat0), this.seen(x1, i, seat1)),
    );
  }

  /** How the obstacle lies, or halfway between two such. */
  private seat(x: Float64Array, other = x): Seat {
    const { carriers, back } = this;
    if (carriers.length === 0) return FAST;
    const [middle, first, second] = carriers.map((point) => lerp(pointAt(x, point), pointAt(other, point), 0.5));
    const gone = sub(middle, this.plain.obstacle.middle);
    if (!first || !second) return { gone };
    const [along, arm] = [normalize(sub(first, middle)), sub(second, middle)];
    const across = normalize(addScaled(arm, along, -dot(arm, along)));
    const axes = transpose([...along, ...across, ...cross(along, across)]);
    const turn = multiply(axes, back);
    return { gone, turn, unturn: transpose(turn) };
  }

  /** A point as the obstacle sees it. */
  private seen(x: Float64Array, i: number, { gone, unturn }: Seat): Vec3 {
    const place = sub(pointAt(x, i), gone);
    const { middle } = this.plain.obstacle;
    return unturn ? add(middle, transform(unturn, sub(place, middle))) : place;
  }

  private out(x: Float64Array, i: number, seat: Seat): Vec3 {
    return toWorld(this.plain.obstacle.outside(this.seen(x, i, seat))[1], seat);
  }

  private distance(x: Float64Array, i: number, seat: Seat): number {
    const { obstacle } = this.plain;
    const { gone, turn } = seat;
    if (turn) return obstacle.distance(...this.seen(x, i, seat));
    return obstacle.distance(x[3 * i] - gone[0], x[3 * i + 1] - gone[1], x[3 * i + 2] - gone[2]);
  }

  private depth(x: Float64Array, i: number, seat: Seat): number {
    return Math.max(0, this.plain.margin - this.distance(x, i, seat));
  }

  /** How far a point goes, as the obstacle sees it [m]. */
  private goes(x0: Float64Array, x1: Float64Array, i: number, seat0: Seat, seat1: Seat): number {
    if (seat0.turn) return length(sub(this.seen(x1, i, seat1), this.seen(x0, i, seat0)));
    const dx = x1[3 * i] - x0[3 * i] - (seat1.gone[0] - seat0.gone[0]);
    const dy = x1[3 * i + 1] - x0[3 * i + 1] - (seat1.gone[1] - seat0.gone[1]);
    const dz = x1[3 * i + 2] - x0[3 * i + 2] - (seat1.gone[2] - seat0.gone[2]);
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }
}

/** A direction that the obstacle sees. */
const toWorld = (way: Vec3, { turn }: Seat): Vec3 => (turn ? transform(turn, way) : way);

/** Whether the way out is the opposite one at the other end of a straight way that leads through the inside. */
function wentThrough(obstacle: Obstacle, from: Vec3, to: Vec3): boolean {
  if (dot(obstacle.outside(from)[1], obstacle.outside(to)[1]) >= 0) return false;
  const way = sub(to, from);
  const outside = (share: number): number => obstacle.outside(addScaled(from, way, share))[0];
  // What is solid is convex, and so is the distance from it along a straight way.
  let [a, b] = [0, 1];
  for (let k = 0; k < SEARCH; k++) {
    const [p, q] = [a + (b - a) / 3, b - (b - a) / 3];
    if (Math.min(outside(p), outside(q)) < 0) return true;
    if (outside(p) < outside(q)) b = q;
    else a = p;
  }
  return false;
}

function push(sum: Float64Array, i: number, way: Vec3, f: number): void {
  for (let k = 0; k < 3; k++) sum[3 * i + k] += f * way[k];
}

interface Pressed {
  readonly point: number;
  readonly out: Vec3;
  readonly K: number;
}

/** K n nᵀ of each point that is pressed; what bends of the surface is left out. */
class BarrierStiffness implements Stiffness {
  private readonly pressed: readonly Pressed[];

  constructor(pressed: readonly Pressed[]) {
    this.pressed = pressed;
  }

  multiply(u: Float64Array, sum: Float64Array): void {
    for (const { point, out, K } of this.pressed) push(sum, point, out, K * dot(out, pointAt(u, point)));
  }

  addBlocks(blocks: Float64Array): void {
    for (const { point, out, K } of this.pressed) addBlock(blocks, point, 0, K, ...out);
  }
}
