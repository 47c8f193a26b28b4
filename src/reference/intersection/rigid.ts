import { multiply } from '../../math/mat3.ts';
import { conjugate, rotate, toMatrix } from '../../math/quat.ts';
import { add, scale, type Vec3 } from '../../math/vec3.ts';
import { gamma, properVelocity } from '../../physics/lorentz/boost.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import { isEternal } from '../../scene/motion/lifetimes.ts';
import type { Pose, SceneObject, UniformMotion } from '../../scene/types.ts';
import { emptyBox, growBox } from '../acceleration/bvh.ts';
import { BvhTraversal } from '../acceleration/bvhTraversal.ts';
import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import {
  type Crossing,
  clipToTimes,
  createHit,
  type MovingBox,
  type ObjectIntersector,
  type RayQuery,
} from '../acceleration/rayQuery.ts';
import { type TriangleBvh, triangleNormal } from '../acceleration/triangleBvh.ts';

const traversal = new BvhTraversal();
/** The current ray in the coordinates of the current object: o x y z, d x y z. */
const line = new Float64Array(6);

/**
 * Intersects rays with an object at rest or in uniform motion. In the coordinates y = M (x − x₀ − v t) its triangles are at rest, and a straight
 * line of events is a straight line: M inverts the object's orientation and, if the object is authored in its rest frame, the contraction.
 */
export class RigidIntersector implements ObjectIntersector {
  readonly index: number;
  readonly doubleSided: boolean;
  private readonly object: SceneObject;
  private readonly shape: TriangleBvh;
  private readonly c: number;
  private readonly pose: Pose;
  /** Velocity [m/s], β [c] and γβ. */
  private readonly velocity: Vec3;
  private readonly beta: Vec3;
  private readonly u: Vec3;
  /** M, row-major. */
  private readonly toObject: Float64Array;
  private readonly hasLifetime: boolean;

  constructor(
    index: number,
    object: SceneObject,
    { pose, velocity }: Pick<UniformMotion, 'pose' | 'velocity'>,
    shape: TriangleBvh,
    c: number,
  ) {
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.shape = shape;
    this.c = c;
    this.pose = pose;
    this.velocity = velocity;
    this.beta = scale(this.velocity, 1 / c);
    this.u = properVelocity(this.beta);
    const toOwnAxes = toMatrix(conjugate(pose.orientation));
    this.toObject = Float64Array.from(
      object.authoredIn === 'rest' ? multiply(toOwnAxes, lengthening(this.u)) : toOwnAxes,
    );
    this.hasLifetime = !isEternal(object.lifetime);
  }

  get bounds(): MovingBox | undefined {
    const { bounds } = this.shape.bvh;
    if (bounds.length === 0) return undefined;
    const box = new Float64Array(6);
    emptyBox(box, 0);
    for (let corner = 0; corner < 8; corner++) {
      const own: Vec3 = [bounds[corner & 1 ? 3 : 0], bounds[corner & 2 ? 4 : 1], bounds[corner & 4 ? 5 : 2]];
      const rotated = rotate(this.pose.orientation, own);
      const offset = this.object.authoredIn === 'rest' ? contraction(rotated, this.u) : rotated;
      const at = add(this.pose.position, offset);
      growBox(box, 0, [...at, ...at], 0);
    }
    return { box: [...box], velocity: this.velocity };
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    let { begin, end } = search;
    if (this.hasLifetime) {
      const { birth, death } = this.object.lifetime;
      [begin, end] = clipToTimes(ray, birth, death, this.c, begin, end);
      if (begin > end) return;
    }
    this.toObjectCoordinates(ray);
    traversal.start(this.shape.bvh, line, begin);
    this.intersectLeaves(begin, end, search);
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const { mesh, authoredIn } = this.object;
    const plane = rotate(this.pose.orientation, triangleNormal(mesh, crossing.corner));
    const N = authoredIn === 'world' ? contraction(plane, this.u) : plane;
    return createHit(ray, this.index, crossing, this.c, this.beta, N);
  }

  /** Writes the ray in the object's coordinates to `line`. */
  private toObjectCoordinates({ t, x, dt, dx }: SpacetimeRay): void {
    const { toObject: m, velocity: v, beta } = this;
    const p = this.pose.position;
    const [ox, oy, oz] = [x[0] - p[0] - v[0] * t, x[1] - p[1] - v[1] * t, x[2] - p[2] - v[2] * t];
    const [dX, dY, dZ] = [dx[0] - beta[0] * dt, dx[1] - beta[1] * dt, dx[2] - beta[2] * dt];
    for (let i = 0; i < 3; i++) {
      line[i] = m[3 * i] * ox + m[3 * i + 1] * oy + m[3 * i + 2] * oz;
      line[3 + i] = m[3 * i] * dX + m[3 * i + 1] * dY + m[3 * i + 2] * dZ;
    }
  }

  /**
   * Intersects the triangles of all leaves along the ray. Corners are sheared so that the ray runs along an axis, identically for all triangles
   * that share a corner; so both triangles at an edge agree on the side on which the ray passes it, and no ray slips through.
   * Source: Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1).
   */
  private intersectLeaves(begin: number, end: number, search: RayQuery): void {
    const { corners, first, bvh } = this.shape;
    const z = longestAxis(line);
    const x = (z + 1) % 3;
    const y = (z + 2) % 3;
    const ox = line[x];
    const oy = line[y];
    const oz = line[z];
    const sz = 1 / line[3 + z];
    const sx = line[3 + x] * sz;
    const sy = line[3 + y] * sz;
    let limit = end;
    for (let leaf = traversal.next(limit); leaf >= 0; leaf = traversal.next(limit)) {
      const from = bvh.link[leaf];
      for (let i = from; i < from + bvh.count[leaf]; i++) {
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

function longestAxis(line: Float64Array): number {
  const a = Math.abs(line[3]);
  const b = Math.abs(line[4]);
  const c = Math.abs(line[5]);
  return a >= b && a >= c ? 0 : b >= c ? 1 : 2;
}

/** The inverse of `contraction`, x + (u·x) u/(γ + 1), row-major. */
export function lengthening(u: Vec3): readonly number[] {
  const k = 1 / (gamma(u) + 1);
  return [0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => (i === j ? 1 : 0) + k * u[i] * u[j]));
}
