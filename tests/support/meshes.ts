import { cross, dot, length, sub, type Vec3 } from '../../src/math/vec3.ts';
import { makeMesh } from '../../src/scene/mesh/makeMesh.ts';
import { type Polygons, pointAt } from '../../src/scene/mesh/polygons.ts';
import type { Mesh } from '../../src/scene/types.ts';

export const triangles = (mesh: Mesh): [Vec3, Vec3, Vec3][] =>
  Array.from({ length: mesh.indices.length / 3 }, (_, t) => [
    pointAt(mesh.positions, mesh.indices[3 * t]),
    pointAt(mesh.positions, mesh.indices[3 * t + 1]),
    pointAt(mesh.positions, mesh.indices[3 * t + 2]),
  ]);
export const sum = (xs: readonly number[]): number => xs.reduce((a, b) => a + b, 0);
export const area = (mesh: Mesh): number =>
  sum(triangles(mesh).map(([a, b, c]) => length(cross(sub(b, a), sub(c, a))) / 2));
/** Enclosed volume by the divergence theorem; front sides must be counter-clockwise. */
export const volume = (mesh: Mesh): number => sum(triangles(mesh).map(([a, b, c]) => dot(a, cross(b, c)) / 6));

/** Directed edges between positions (vertices welded by position), with their number of occurrences. */
function edges(mesh: Mesh): { vertices: number; directed: Map<string, number> } {
  const places = new Map<string, number>();
  const place = (p: Vec3) => {
    const key = p.map((x) => x + 0).join(' ');
    if (!places.has(key)) places.set(key, places.size);
    return places.get(key);
  };
  const directed = new Map<string, number>();
  for (const t of triangles(mesh)) {
    const [a, b, c] = t.map(place);
    for (const e of [`${a} ${b}`, `${b} ${c}`, `${c} ${a}`]) directed.set(e, (directed.get(e) ?? 0) + 1);
  }
  return { vertices: places.size, directed };
}

/** A closed surface has each directed edge once, and its reverse once: no crack, no T-junction. */
export function openEdges(mesh: Mesh): number {
  const { directed } = edges(mesh);
  return [...directed].filter(([e, n]) => n !== 1 || directed.get(e.split(' ').reverse().join(' ')) !== 1).length;
}
export const eulerCharacteristic = (mesh: Mesh): number => {
  const { vertices, directed } = edges(mesh);
  return vertices - directed.size / 2 + mesh.indices.length / 3;
};

/** One polygon in the xy plane. */
export const polygon = (outline: readonly (readonly [number, number])[], extra: Partial<Polygons> = {}): Mesh =>
  makeMesh({
    points: outline.flatMap(([x, y]) => [x, y, 0]),
    faceCounts: [outline.length],
    faceIndices: outline.map((_, i) => i),
    ...extra,
  }).mesh;
