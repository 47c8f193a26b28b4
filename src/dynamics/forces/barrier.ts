import { type Mat3, multiply, transform, transpose } from '../../math/mat3.ts';
import { toMatrix } from '../../math/quat.ts';
import { add, addScaled, cross, dot, length, lerp, normalize, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { pointAt } from '../system.ts';
import { addBlock, type BarrierData, type Force, type Stiffness } from './force.ts';
import type { Obstacle } from './obstacle.ts';

/** Ternary search: each iteration discards a third. */
const MAX_SEARCH_STEPS = 40;

/**
 * Pushes points out of an obstacle: V = Σ ½K(margin − d)² over points at distance d < margin. `K` [N/m], `margin` [m].
 * Its discrete gradient is Gonzalez's: the gradient at the midpoint plus a correction along the displacement that makes
 * up for V₁ − V₀. `carriers`: kinematic points that carry the obstacle: its center and, if it rotates, the ends of two
 * arms along its x and y axes; none: it is fixed. Points are then transformed to the obstacle's initial pose.
 * @example
 * // A point 0.1 m below the floor: V = ½ · 1000 N/m · (0.1 m)².
 * const floor = barrier(plane([0, 0, 0], [0, 1, 0]), [0], 1000);
 * floor.energy(Float64Array.of(5, -0.1, 0)); // 5 J
 */
export const barrier = (
  obstacle: Obstacle,
  points: readonly number[],
  K: number,
  margin = 0,
  carriers: readonly number[] = [],
): Force => new Barrier({ kind: 'barrier', obstacle, points, strength: K, margin }, carriers);

/** Pose of an obstacle relative to its initial pose. */
interface ObstacleMotion {
  /** Displacement of its center [m]. */
  readonly translation: Vec3;
  /** Rotation since the start, and its inverse; absent if it does not rotate. */
  readonly rotation?: Mat3;
  readonly inverseRotation?: Mat3;
}
const STATIONARY: ObstacleMotion = { translation: ZERO };

/** Most points are far away most of the time: only their distance is evaluated, without allocating vectors. */
class Barrier implements Force {
  readonly data: BarrierData;
  private readonly carriers: readonly number[];
  /** World axes → the obstacle's own initial axes. */
  private readonly back: Mat3;

  constructor(plain: BarrierData, carriers: readonly number[]) {
    this.data = plain;
    this.carriers = carriers;
    this.back = transpose(toMatrix(plain.obstacle.orientation));
  }

  energy(x: Float64Array): number {
    const { points, strength } = this.data;
    const seat = this.motionAt(x);
    let sum = 0;
    for (const i of points) sum += 0.5 * strength * this.penetration(x, i, seat) ** 2;
    return sum;
  }

  add(x: Float64Array, sum: Float64Array): void {
    const { points, strength } = this.data;
    const seat = this.motionAt(x);
    for (const i of points) {
      const deep = this.penetration(x, i, seat);
      if (deep > 0) addForce(sum, i, this.outwardNormal(x, i, seat), strength * deep);
    }
  }

  addDiscreteGradient(x0: Float64Array, x1: Float64Array, sum: Float64Array): void {
    const { points, margin, obstacle, strength: K } = this.data;
    const [seat0, seat1, halfway] = [this.motionAt(x0), this.motionAt(x1), this.motionAt(x0, x1)];
    for (const i of points) {
      const far0 = this.distance(x0, i, seat0);
      const far1 = this.distance(x1, i, seat1);
      // A point cannot come nearer than by its displacement.
      if (
        Math.min(far0, far1) >= margin &&
        Math.max(far0, far1) - this.localDisplacement(x0, x1, i, seat0, seat1) / 2 >= margin
      )
        continue;
      const a = this.localPoint(x0, i, seat0);
      const way = sub(this.localPoint(x1, i, seat1), a);
      const [distance, out] = obstacle.distanceAndNormal(addScaled(a, way, 0.5));
      const deep = Math.max(0, margin - distance);
      const rise = 0.5 * K * (Math.max(0, margin - far1) ** 2 - Math.max(0, margin - far0) ** 2);
      const square = dot(way, way);
      addForce(sum, i, directionToWorld(out, halfway), K * deep);
      if (square > 0) addForce(sum, i, directionToWorld(way, halfway), -(rise + K * deep * dot(out, way)) / square);
    }
  }

  stiffness(x: Float64Array): Stiffness {
    const { points, strength: K } = this.data;
    const seat = this.motionAt(x);
    const pressed = points.filter((i) => this.penetration(x, i, seat) > 0);
    return new BarrierStiffness(pressed.map((point) => ({ point, out: this.outwardNormal(x, point, seat), K })));
  }

  addStiffnessBound(bound: Float64Array): void {
    for (const i of this.data.points) bound[i] += this.data.strength;
  }

  findTunneled(x0: Float64Array, x1: Float64Array): number | undefined {
    const { points, obstacle } = this.data;
    // A plane cannot be passed through to another side.
    if (!obstacle.halfExtents) return undefined;
    const [seat0, seat1] = [this.motionAt(x0), this.motionAt(x1)];
    return points.find(
      (i) =>
        this.distance(x0, i, seat0) < this.localDisplacement(x0, x1, i, seat0, seat1) &&
        passesThrough(obstacle, this.localPoint(x0, i, seat0), this.localPoint(x1, i, seat1)),
    );
  }

  /** Relative pose at a state, or midway between two. */
  private motionAt(x: Float64Array, other = x): ObstacleMotion {
    const { carriers, back } = this;
    if (carriers.length === 0) return STATIONARY;
    const [middle, first, second] = carriers.map((point) => lerp(pointAt(x, point), pointAt(other, point), 0.5));
    const gone = sub(middle, this.data.obstacle.center);
    if (!first || !second) return { translation: gone };
    const [along, arm] = [normalize(sub(first, middle)), sub(second, middle)];
    const across = normalize(addScaled(arm, along, -dot(arm, along)));
    const axes = transpose([...along, ...across, ...cross(along, across)]);
    const turn = multiply(axes, back);
    return { translation: gone, rotation: turn, inverseRotation: transpose(turn) };
  }

  /** A point in the obstacle's frame. */
  private localPoint(x: Float64Array, i: number, { translation, inverseRotation }: ObstacleMotion): Vec3 {
    const place = sub(pointAt(x, i), translation);
    const { center: middle } = this.data.obstacle;
    return inverseRotation ? add(middle, transform(inverseRotation, sub(place, middle))) : place;
  }

  private outwardNormal(x: Float64Array, i: number, seat: ObstacleMotion): Vec3 {
    return directionToWorld(this.data.obstacle.distanceAndNormal(this.localPoint(x, i, seat))[1], seat);
  }

  private distance(x: Float64Array, i: number, seat: ObstacleMotion): number {
    const { obstacle } = this.data;
    const { translation, rotation: turn } = seat;
    if (turn) return obstacle.distance(...this.localPoint(x, i, seat));
    return obstacle.distance(x[3 * i] - translation[0], x[3 * i + 1] - translation[1], x[3 * i + 2] - translation[2]);
  }

  private penetration(x: Float64Array, i: number, seat: ObstacleMotion): number {
    return Math.max(0, this.data.margin - this.distance(x, i, seat));
  }

  /** Displacement of a point in the obstacle's frame [m]. */
  private localDisplacement(
    x0: Float64Array,
    x1: Float64Array,
    i: number,
    seat0: ObstacleMotion,
    seat1: ObstacleMotion,
  ): number {
    if (seat0.rotation) return length(sub(this.localPoint(x1, i, seat1), this.localPoint(x0, i, seat0)));
    const dx = x1[3 * i] - x0[3 * i] - (seat1.translation[0] - seat0.translation[0]);
    const dy = x1[3 * i + 1] - x0[3 * i + 1] - (seat1.translation[1] - seat0.translation[1]);
    const dz = x1[3 * i + 2] - x0[3 * i + 2] - (seat1.translation[2] - seat0.translation[2]);
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }
}

/** A direction from the obstacle's frame to the world. */
const directionToWorld = (way: Vec3, { rotation: turn }: ObstacleMotion): Vec3 => (turn ? transform(turn, way) : way);

/** Whether the outward direction reverses along a straight path through the inside. */
function passesThrough(obstacle: Obstacle, from: Vec3, to: Vec3): boolean {
  if (dot(obstacle.distanceAndNormal(from)[1], obstacle.distanceAndNormal(to)[1]) >= 0) return false;
  const way = sub(to, from);
  const outside = (share: number): number => obstacle.distanceAndNormal(addScaled(from, way, share))[0];
  // Obstacles are convex, and so is the distance along a straight path.
  let [a, b] = [0, 1];
  for (let k = 0; k < MAX_SEARCH_STEPS; k++) {
    const [p, q] = [a + (b - a) / 3, b - (b - a) / 3];
    if (Math.min(outside(p), outside(q)) < 0) return true;
    if (outside(p) < outside(q)) b = q;
    else a = p;
  }
  return false;
}

function addForce(sum: Float64Array, i: number, way: Vec3, f: number): void {
  for (let k = 0; k < 3; k++) sum[3 * i + k] += f * way[k];
}

interface ActiveContact {
  readonly point: number;
  readonly out: Vec3;
  readonly K: number;
}

/** K n nᵀ of each point in contact; the curvature of the surface is neglected. */
class BarrierStiffness implements Stiffness {
  private readonly pressed: readonly ActiveContact[];

  constructor(pressed: readonly ActiveContact[]) {
    this.pressed = pressed;
  }

  multiply(u: Float64Array, sum: Float64Array): void {
    for (const { point, out, K } of this.pressed) addForce(sum, point, out, K * dot(out, pointAt(u, point)));
  }

  addBlocks(blocks: Float64Array): void {
    for (const { point, out, K } of this.pressed) addBlock(blocks, point, 0, K, ...out);
  }
}
