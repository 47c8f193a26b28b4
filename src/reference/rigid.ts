import { multiply, transform } from '../math/mat3.ts';
import { conjugate, rotate, toMatrix } from '../math/quat.ts';
import { addScaled, normalize, scale, sub, type Vec3, ZERO } from '../math/vec3.ts';
import { gamma, properVelocity } from '../physics/boost.ts';
import { contraction } from '../physics/simultaneity.ts';
import type { Pose, SceneObject, StaticMotion, UniformMotion } from '../scene/types.ts';
import { type Crossing, eventOf, type Search, spanBetween, type Tracer } from './search.ts';
import { planeOf, type TriangleTree } from './triangleTree.ts';
import type { Hit, SpacetimeRay } from './types.ts';
import { Walk } from './walk.ts';

const walk = new Walk();

/**
 * An object at rest or at constant speed. In the coordinates y = M (x − x₀ − v t) its triangles stand still, and a straight line of
 * events is a straight line: M turns back the object's orientation and, where the object is authored in its rest frame, undoes the contraction.
 */
export class RigidTracer implements Tracer {
  private readonly index: number;
  private readonly object: SceneObject;
  private readonly shape: TriangleTree;
  private readonly c: number;
  private readonly pose: Pose;
  /** [m/s] */
  private readonly velocity: Vec3;
  /** M, row by row. */
  private readonly toObject: readonly number[];

  constructor(
    index: number,
    object: SceneObject & { readonly motion: StaticMotion | UniformMotion },
    shape: TriangleTree,
    c: number,
  ) {
    const { motion } = object;
    this.index = index;
    this.object = object;
    this.shape = shape;
    this.c = c;
    this.pose = motion.pose;
    this.velocity = motion.kind === 'uniform' ? motion.velocity : ZERO;
    const turn = toMatrix(conjugate(motion.pose.orientation));
    this.toObject = object.authoredIn === 'rest' ? multiply(turn, lengthening(this.u)) : turn;
  }

  trace(ray: SpacetimeRay, search: Search): void {
    const { birth, death } = this.object.lifetime;
    const [begin, end] = spanBetween(ray, birth, death, this.c, search.begin, search.end);
    if (begin > end) return;
    const [o, d] = [this.origin(ray), this.way(ray)];
    walk.start(this.shape.tree, o[0], o[1], o[2], d[0], d[1], d[2], begin);
    this.visit(o, d, begin, end, search);
  }

  describe(ray: SpacetimeRay, crossing: Crossing): Hit {
    const { mesh, authoredIn } = this.object;
    const plane = planeOf(mesh, crossing.corner);
    const turned = rotate(this.pose.orientation, plane);
    return {
      ...eventOf(ray, this.index, crossing, this.c),
      velocity: scale(this.velocity, 1 / this.c),
      normal: normalize(authoredIn === 'rest' ? turned : contraction(turned, this.u)),
    };
  }

  private get u(): Vec3 {
    return properVelocity(scale(this.velocity, 1 / this.c));
  }

  private origin({ t, x }: SpacetimeRay): Vec3 {
    return transform(this.toObject, sub(x, addScaled(this.pose.position, this.velocity, t)));
  }

  private way({ dt, dx }: SpacetimeRay): Vec3 {
    return transform(this.toObject, addScaled(dx, this.velocity, -dt / this.c));
  }

  /**
   * Tries the triangles of all leaves on the way. Each corner is sheared so that the ray runs along an axis, alike for all triangles
   * that share it; an edge's sign then is the same for both of its sides, so no ray slips through.
   * Source: Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1).
   */
  private visit(o: Vec3, d: Vec3, begin: number, end: number, search: Search): void {
    const { corners, first, tree } = this.shape;
    const z = longestAxis(d);
    const x = (z + 1) % 3;
    const y = (z + 2) % 3;
    const [ox, oy, oz] = [o[x], o[y], o[z]];
    const sz = 1 / d[z];
    const sx = d[x] * sz;
    const sy = d[y] * sz;
    let limit = end;
    for (let leaf = walk.next(limit); leaf >= 0; leaf = walk.next(limit)) {
      const from = tree.link[leaf];
      for (let i = from; i < from + tree.count[leaf]; i++) {
        const k = 9 * i;
        const az = corners[k + z] - oz;
        const bz = corners[k + 3 + z] - oz;
        const cz = corners[k + 6 + z] - oz;
        const ax = corners[k + x] - ox - sx * az;
        const bx = corners[k + 3 + x] - ox - sx * bz;
        const cx = corners[k + 6 + x] - ox - sx * cz;
        const ay = corners[k + y] - oy - sy * az;
        const by = corners[k + 3 + y] - oy - sy * bz;
        const cy = corners[k + 6 + y] - oy - sy * cz;
        const p = cx * by - cy * bx;
        const q = ax * cy - ay * cx;
        const r = bx * ay - by * ax;
        if ((p < 0 || q < 0 || r < 0) && (p > 0 || q > 0 || r > 0)) continue;
        const sum = p + q + r;
        const s = ((p * az + q * bz + r * cz) / sum) * sz;
        if (!(s >= begin && s <= limit)) continue;
        if (search.offer(this, s, first[i], q / sum, r / sum, sum * sz > 0, 0)) limit = s;
      }
    }
  }
}

function longestAxis([x, y, z]: Vec3): number {
  const [a, b, c] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  return a >= b && a >= c ? 0 : b >= c ? 1 : 2;
}

/** The inverse of `contraction`, x + (u·x) u/(γ + 1), row by row. */
function lengthening(u: Vec3): readonly number[] {
  const k = 1 / (gamma(u) + 1);
  return [0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => (i === j ? 1 : 0) + k * u[i] * u[j]));
}
