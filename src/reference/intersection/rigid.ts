import { IDENTITY, invert, multiply, transform } from '../../math/mat3.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { stretchedNormal } from '../../scene/mesh/stretch.ts';
import { isEternal } from '../../scene/motion/lifetimes.ts';
import type { SceneObject, UniformMotion } from '../../scene/types.ts';
import { BvhTraversal } from '../acceleration/bvhTraversal.ts';
import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import {
  type Crossing,
  clipToTimes,
  type MovingBox,
  type ObjectIntersector,
  type RayQuery,
} from '../acceleration/rayQuery.ts';
import { type TriangleBvh, triangleNormal } from '../acceleration/triangleBvh.ts';
import { RigidFrame } from './rigidFrame.ts';

const traversal = new BvhTraversal();
/** The current ray in the axes of the current object's mesh: o x y z, d x y z. */
const line = new Float64Array(6);

/** Intersects rays with an object at rest or in uniform motion. */
export class RigidIntersector implements ObjectIntersector {
  readonly index: number;
  readonly doubleSided: boolean;
  private readonly object: SceneObject;
  private readonly shape: TriangleBvh;
  private readonly c: number;
  private readonly frame: RigidFrame;
  /** The frame's map, and from the object's axes to those of the mesh. */
  private readonly toMesh: Float64Array;
  private readonly hasLifetime: boolean;

  constructor(
    index: number,
    object: SceneObject,
    motion: Pick<UniformMotion, 'pose' | 'velocity'>,
    shape: TriangleBvh,
    c: number,
  ) {
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.shape = shape;
    this.c = c;
    this.frame = new RigidFrame(object.authoredIn, motion, c);
    const toMesh = object.stretch && invert(object.stretch);
    this.toMesh = Float64Array.from(toMesh ? multiply(toMesh, this.frame.toObject) : this.frame.toObject);
    this.hasLifetime = !isEternal(object.lifetime);
  }

  get bounds(): MovingBox | undefined {
    const { bounds } = this.shape.bvh;
    if (bounds.length === 0) return undefined;
    const { stretch = IDENTITY } = this.object;
    const corner = (k: number): Vec3 =>
      transform(stretch, [bounds[k & 1 ? 3 : 0], bounds[k & 2 ? 4 : 1], bounds[k & 4 ? 5 : 2]]);
    return this.frame.boxAround([0, 1, 2, 3, 4, 5, 6, 7].map(corner));
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    let { begin, end } = search;
    if (this.hasLifetime) {
      const { birth, death } = this.object.lifetime;
      [begin, end] = clipToTimes(ray, birth, death, this.c, begin, end);
      if (begin > end) return;
    }
    this.frame.writeLine(ray, this.toMesh, line);
    traversal.start(this.shape.bvh, line, begin);
    this.intersectLeaves(begin, end, search);
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const { mesh, stretch } = this.object;
    const normal = stretchedNormal(triangleNormal(mesh, crossing.corner), stretch);
    return this.frame.hitAt(ray, this.index, crossing, normal);
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
        if (search.offer(this, s, first[i], q / sum, r / sum, sum * sz > 0, 0)) limit = search.end;
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
