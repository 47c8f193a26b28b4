import { cross, sub, type Vec3 } from '../../math/vec3.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import type { Mesh } from '../../scene/types.ts';
import { type Bvh, buildBvh, emptyBox } from './bvh.ts';

/** The triangles of a mesh in a BVH, in the object's own frame. */
export interface TriangleBvh {
  readonly bvh: Bvh;
  /** 9 numbers per triangle, in leaf order [m]. */
  readonly corners: Float32Array;
  /** Index in `mesh.indices` of each triangle's first corner, in leaf order. */
  readonly first: Uint32Array;
}

/** By positions, since instances of a mesh may have other materials. */
const BVH_CACHE = new WeakMap<Float32Array, { readonly indices: Uint32Array; readonly tree: TriangleBvh }>();

/** `buildTriangleBvh`, cached for all objects that share a mesh. */
export function meshBvh(mesh: Mesh): TriangleBvh {
  const cached = BVH_CACHE.get(mesh.positions);
  if (cached?.indices === mesh.indices) return cached.tree;
  const tree = buildTriangleBvh(mesh);
  BVH_CACHE.set(mesh.positions, { indices: mesh.indices, tree });
  return tree;
}

export function buildTriangleBvh({ positions, indices }: Mesh): TriangleBvh {
  const finite = finiteTriangles(positions, indices);
  const boxes = new Float64Array(6 * finite.length);
  for (let i = 0; i < finite.length; i++) boxOfTriangle(boxes, 6 * i, positions, indices, finite[i]);
  const tree = buildBvh(boxes);
  const first = tree.order.map((i) => finite[i]);
  const corners = new Float32Array(9 * first.length);
  for (let i = 0; i < first.length; i++)
    for (let k = 0; k < 9; k++) corners[9 * i + k] = positions[3 * indices[first[i] + ((k / 3) | 0)] + (k % 3)];
  return { bvh: tree, corners, first };
}

/** The triangles with finite coordinates only, each as the index of its first corner. */
function finiteTriangles(positions: ArrayLike<number>, indices: Uint32Array): Uint32Array {
  const finite = new Uint32Array(Math.floor(indices.length / 3));
  let n = 0;
  for (let at = 0; at + 2 < indices.length; at += 3) {
    let sum = 0;
    for (let k = 0; k < 9; k++) sum += positions[3 * indices[at + ((k / 3) | 0)] + (k % 3)];
    if (Number.isFinite(sum)) finite[n++] = at;
  }
  return finite.subarray(0, n);
}

/** A normal, of any length, of the triangle whose first corner is `indices[at]`, in the object's own frame, on its front side. */
export function triangleNormal({ positions, indices }: Mesh, at: number): Vec3 {
  const a = pointAt(positions, indices[at]);
  return cross(sub(pointAt(positions, indices[at + 1]), a), sub(pointAt(positions, indices[at + 2]), a));
}

/** Sets the box at k to that of the triangle whose first corner is `indices[at]`. */
export function boxOfTriangle(
  boxes: Float64Array,
  k: number,
  positions: ArrayLike<number>,
  indices: Uint32Array,
  at: number,
): void {
  emptyBox(boxes, k);
  for (let corner = at; corner < at + 3; corner++)
    for (let i = 0; i < 3; i++) {
      const x = positions[3 * indices[corner] + i];
      if (x < boxes[k + i]) boxes[k + i] = x;
      if (x > boxes[k + 3 + i]) boxes[k + 3 + i] = x;
    }
}
