import { cross, dot, normalize, sub, type Vec3 } from '../../math/vec3.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import type { Mesh } from '../../scene/types.ts';

/** The facets of one solid. */
export interface Facets {
  readonly name: string;
  /** 9 per facet. */
  readonly points: Float32Array;
  /** Number of facets whose authored normal opposes their winding. */
  readonly turned: number;
}

/** Normal by winding order, not normalized. */
export function facetNormal(points: ArrayLike<number>, facet: number): Vec3 {
  const a = pointAt(points, 3 * facet);
  return cross(sub(pointAt(points, 3 * facet + 1), a), sub(pointAt(points, 3 * facet + 2), a));
}

/** Whether an authored normal opposes the winding. */
export const isTurned = (written: Vec3, corners: Vec3): boolean => dot(written, corners) < 0;

/** Flat-shaded triangles without shared vertices. */
export function facetMesh({ points }: Facets): Mesh {
  const vertices = points.length / 3;
  const normals = new Float32Array(points.length);
  for (let v = 0; v < vertices; v += 3) {
    const n = normalize(facetNormal(points, v / 3), [0, 0, 1]);
    for (let i = 0; i < 9; i++) normals[3 * v + i] = n[i % 3];
  }
  return {
    positions: points,
    normals,
    uvs: new Float32Array(2 * vertices),
    indices: new Uint32Array(vertices).map((_, v) => v),
    groups: [{ start: 0, count: vertices, material: 0 }],
    // Winding is unreliable in scans and many exporters.
    doubleSided: true,
  };
}
