import { cofactors, determinant, transform } from '../../math/mat3.ts';
import { linearPart, type Mat4, transformPoint } from '../../math/mat4.ts';
import { normalize } from '../../math/vec3.ts';
import type { Mesh, MeshGroup } from '../types.ts';
import { pointAt } from './polygons.ts';
import { transformedQuadric, withoutQuadric } from './quadric.ts';

/**
 * Merges meshes, which keep their groups and therefore their materials. Colours of parts without any are white.
 * @example
 * mergeMeshes([box([1, 1, 1]), box([2, 2, 2])]).indices.length; // 72: 24 triangles
 */
export function mergeMeshes(parts: readonly Mesh[]): Mesh {
  const starts = runningSums(parts.map((m) => m.positions.length / 3));
  const indexStarts = runningSums(parts.map((m) => m.indices.length));
  const indices = new Uint32Array(indexStarts[parts.length]);
  parts.forEach((m, i) => {
    m.indices.forEach((v, k) => {
      indices[indexStarts[i] + k] = v + starts[i];
    });
  });
  const groups = parts.flatMap((m, i) => m.groups.map((g) => ({ ...g, start: g.start + indexStarts[i] })));
  const colored = parts.some((m) => m.colors !== undefined);
  return {
    positions: concat(parts.map((m) => m.positions)),
    normals: concat(parts.map((m) => m.normals)),
    uvs: concat(parts.map((m) => m.uvs)),
    ...(colored ? { colors: concat(parts.map((m) => m.colors ?? new Float32Array(m.positions.length).fill(1))) } : {}),
    indices,
    groups: joinGroups(groups),
    doubleSided: parts.some((m) => m.doubleSided),
  };
}

/** Joins consecutive groups of the same material, to save draw calls. */
function joinGroups(groups: readonly MeshGroup[]): MeshGroup[] {
  const out: MeshGroup[] = [];
  for (const g of groups) {
    const last = out[out.length - 1];
    if (last && last.material === g.material && last.start + last.count === g.start) {
      out[out.length - 1] = { ...last, count: last.count + g.count };
    } else out.push(g);
  }
  return out;
}

function runningSums(counts: readonly number[]): number[] {
  const sums = [0];
  for (const n of counts) sums.push(sums[sums.length - 1] + n);
  return sums;
}

function concat(parts: readonly Float32Array[]): Float32Array {
  const out = new Float32Array(parts.reduce((n, p) => n + p.length, 0));
  let at = 0;
  for (const p of parts) {
    out.set(p, at);
    at += p.length;
  }
  return out;
}

/**
 * Transforms every point x → M x. Normals are transformed by the cofactor matrix, so that they stay perpendicular under scale and shear; a reflection reverses
 * the winding.
 * @example
 * import { mat3, mat4 } from 'slowlight/math';
 * const moved = transformMesh(box([2, 2, 2]), mat4.fromParts(mat3.IDENTITY, [5, 0, 0]));
 * boundingBox(moved.positions); // { min: [4, -1, -1], max: [6, 1, 1] } m
 */
export function transformMesh(mesh: Mesh, m: Mat4): Mesh {
  const linear = linearPart(m);
  const mirrored = determinant(linear) < 0;
  const normalMatrix = cofactors(linear).map((x) => (mirrored ? -x : x));
  const positions = new Float32Array(mesh.positions.length);
  const normals = new Float32Array(mesh.normals.length);
  for (let v = 0; v < positions.length / 3; v++) {
    const normal = pointAt(mesh.normals, v);
    positions.set(transformPoint(m, pointAt(mesh.positions, v)), 3 * v);
    normals.set(normalize(transform(normalMatrix, normal), normal), 3 * v);
  }
  const indices = mirrored ? flippedWinding(mesh.indices) : mesh.indices;
  return { ...withoutQuadric(mesh), positions, normals, indices, ...transformedQuadric(mesh.quadric, m) };
}

/** Triangles with the other side as their front. */
export function flippedWinding(indices: Uint32Array): Uint32Array {
  const out = indices.slice();
  for (let i = 0; i + 2 < out.length; i += 3) {
    out[i + 1] = indices[i + 2];
    out[i + 2] = indices[i + 1];
  }
  return out;
}

/**
 * Assigns one material to all triangles.
 * @example
 * withMaterial(box([1, 1, 1]), 3).groups; // [{ start: 0, count: 36, material: 3 }]
 */
export const withMaterial = (mesh: Mesh, material: number): Mesh => ({
  ...mesh,
  groups: [{ start: 0, count: mesh.indices.length, material }],
});
