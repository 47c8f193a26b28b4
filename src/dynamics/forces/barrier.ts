import { add, addScaled, dot, sub, type Vec3 } from '../../math/vec3.ts';
import { addBlock, type Force, type Stiffness } from './force.ts';
import type { Obstacle } from './obstacle.ts';

/** A third is cut off so often. */
const SEARCH = 40;

/**
 * Pushes points out of an obstacle: V = Σ ½K(margin − d)² of those whose distance d is below the margin. `K` [N/m], `margin` [m]. Its discrete gradient is Gonzalez's:
 * the gradient halfway, and along the way what is missing of V₁ − V₀. `carrier`: a point that is led, which the obstacle's middle goes with; absent: it stands fast.
 */
export function barrier(
  obstacle: Obstacle,
  points: readonly number[],
  K: number,
  margin = 0,
  carrier: number | undefined = undefined,
): Force {
  /** As seen from the obstacle. */
  const at = (x: Float64Array, i: number): Vec3 =>
    carrier === undefined ? pointAt(x, i) : add(obstacle.middle, sub(pointAt(x, i), pointAt(x, carrier)));
  const depth = (place: Vec3): readonly [number, Vec3] => {
    const [distance, out] = obstacle.outside(place);
    return [Math.max(0, margin - distance), out];
  };
  const energyAt = (place: Vec3): number => 0.5 * K * depth(place)[0] ** 2;
  return {
    plain: { kind: 'barrier', obstacle, points, strength: K, margin },
    energy: (x) => points.reduce((sum, i) => sum + energyAt(at(x, i)), 0),
    add(x, sum) {
      for (const i of points) {
        const [deep, out] = depth(at(x, i));
        if (deep > 0) push(sum, i, out, K * deep);
      }
    },
    addMean(x0, x1, sum) {
      for (const i of points) {
        const [a, b] = [at(x0, i), at(x1, i)];
        const rise = energyAt(b) - energyAt(a);
        const way = sub(b, a);
        const [deep, out] = depth(addScaled(a, way, 0.5));
        const square = dot(way, way);
        push(sum, i, out, K * deep);
        if (square > 0) push(sum, i, way, -(rise + K * deep * dot(out, way)) / square);
      }
    },
    stiffness: (x) => new BarrierStiffness(points.flatMap((i) => pressed(i, depth(at(x, i)), K))),
    addRigidity(bound) {
      for (const i of points) bound[i] += K;
    },
    pierced: (x0, x1) => points.find((i) => wentThrough(obstacle, at(x0, i), at(x1, i))),
  };
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

const pointAt = (x: Float64Array, i: number): Vec3 => [x[3 * i], x[3 * i + 1], x[3 * i + 2]];

function push(sum: Float64Array, i: number, way: Vec3, f: number): void {
  for (let k = 0; k < 3; k++) sum[3 * i + k] += f * way[k];
}

interface Pressed {
  readonly point: number;
  readonly out: Vec3;
  readonly K: number;
}

const pressed = (point: number, [deep, out]: readonly [number, Vec3], K: number): Pressed[] =>
  deep > 0 ? [{ point, out, K }] : [];

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
