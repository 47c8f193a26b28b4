import { addScaled, dot, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { pointAt } from '../system.ts';
import { addBlock, type Force, type PlainBarrier, type Stiffness } from './force.ts';
import type { Obstacle } from './obstacle.ts';

/** A third is cut off so often. */
const SEARCH = 40;

/**
 * Pushes points out of an obstacle: V = Σ ½K(margin − d)² of those whose distance d is below the margin. `K` [N/m], `margin` [m]. Its discrete gradient is Gonzalez's:
 * the gradient halfway, and along the way what is missing of V₁ − V₀. `carrier`: a point that is led, which the obstacle's middle goes with; absent: it stands fast.
 */
export const barrier = (
  obstacle: Obstacle,
  points: readonly number[],
  K: number,
  margin = 0,
  carrier: number | undefined = undefined,
): Force => new Barrier({ kind: 'barrier', obstacle, points, strength: K, margin }, carrier);

/** Most points are far off most of the time: they are asked for their distance alone, number by number. */
class Barrier implements Force {
  readonly plain: PlainBarrier;
  private readonly carrier: number | undefined;

  constructor(plain: PlainBarrier, carrier: number | undefined) {
    this.plain = plain;
    this.carrier = carrier;
  }

  energy(x: Float64Array): number {
    const { points, strength } = this.plain;
    const gone = this.gone(x);
    let sum = 0;
    for (const i of points) sum += 0.5 * strength * this.depth(x, i, gone) ** 2;
    return sum;
  }

  add(x: Float64Array, sum: Float64Array): void {
    const { points, strength, obstacle } = this.plain;
    const gone = this.gone(x);
    for (const i of points) {
      const deep = this.depth(x, i, gone);
      if (deep > 0) push(sum, i, obstacle.outside(sub(pointAt(x, i), gone))[1], strength * deep);
    }
  }

  addMean(x0: Float64Array, x1: Float64Array, sum: Float64Array): void {
    const { points, margin, obstacle, strength: K } = this.plain;
    const gone0 = this.gone(x0);
    const gone1 = this.gone(x1);
    for (const i of points) {
      const far0 = this.distance(x0, i, gone0);
      const far1 = this.distance(x1, i, gone1);
      // Nobody is nearer by more than he goes.
      if (Math.max(far0, far1) - wayBetween(x0, x1, i, gone0, gone1) / 2 >= margin && Math.min(far0, far1) >= margin)
        continue;
      const a = sub(pointAt(x0, i), gone0);
      const way = sub(sub(pointAt(x1, i), gone1), a);
      const [distance, out] = obstacle.outside(addScaled(a, way, 0.5));
      const deep = Math.max(0, margin - distance);
      const rise = 0.5 * K * (Math.max(0, margin - far1) ** 2 - Math.max(0, margin - far0) ** 2);
      const square = dot(way, way);
      push(sum, i, out, K * deep);
      if (square > 0) push(sum, i, way, -(rise + K * deep * dot(out, way)) / square);
    }
  }

  stiffness(x: Float64Array): Stiffness {
    const { points, strength: K, obstacle } = this.plain;
    const gone = this.gone(x);
    const pressed = points.filter((i) => this.depth(x, i, gone) > 0);
    return new BarrierStiffness(
      pressed.map((point) => ({ point, out: obstacle.outside(sub(pointAt(x, point), gone))[1], K })),
    );
  }

  addRigidity(bound: Float64Array): void {
    for (const i of this.plain.points) bound[i] += this.plain.strength;
  }

  pierced(x0: Float64Array, x1: Float64Array): number | undefined {
    const { points, obstacle } = this.plain;
    // A plane has no other side.
    if (!obstacle.half) return undefined;
    const gone0 = this.gone(x0);
    const gone1 = this.gone(x1);
    return points.find(
      (i) =>
        this.distance(x0, i, gone0) < wayBetween(x0, x1, i, gone0, gone1) &&
        wentThrough(obstacle, sub(pointAt(x0, i), gone0), sub(pointAt(x1, i), gone1)),
    );
  }

  /** How far an obstacle that is carried has gone. */
  private gone(x: Float64Array): Vec3 {
    const { carrier } = this;
    return carrier === undefined ? ZERO : sub(pointAt(x, carrier), this.plain.obstacle.middle);
  }

  private distance(x: Float64Array, i: number, gone: Vec3): number {
    return this.plain.obstacle.distance(x[3 * i] - gone[0], x[3 * i + 1] - gone[1], x[3 * i + 2] - gone[2]);
  }

  private depth(x: Float64Array, i: number, gone: Vec3): number {
    return Math.max(0, this.plain.margin - this.distance(x, i, gone));
  }
}

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

/** How far a point goes, as seen from what goes too [m]. */
function wayBetween(x0: Float64Array, x1: Float64Array, i: number, gone0: Vec3, gone1: Vec3): number {
  const dx = x1[3 * i] - x0[3 * i] - (gone1[0] - gone0[0]);
  const dy = x1[3 * i + 1] - x0[3 * i + 1] - (gone1[1] - gone0[1]);
  const dz = x1[3 * i + 2] - x0[3 * i + 2] - (gone1[2] - gone0[2]);
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
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
