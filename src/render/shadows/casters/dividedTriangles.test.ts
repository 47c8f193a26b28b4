import { describe, expect, it } from 'vitest';
import { box, grid } from '../../../scene/mesh/primitives.ts';
import type { Mesh } from '../../../scene/types.ts';
import { dividedTriangles, PART_FLOATS } from './dividedTriangles.ts';

const arraysOf = (mesh: Mesh) => ({ ...mesh, ids: new Float32Array((2 * mesh.positions.length) / 3) });

/** The corners of all parts, relative to the origin [m], to 10⁻⁶. */
function cornersOf(mesh: Mesh, parts: Float32Array): number[][] {
  const at = (v: number) => [0, 1, 2].map((k) => mesh.positions[3 * mesh.indices[v] + k]);
  return Array.from({ length: parts.length / PART_FLOATS }, (_, i) => {
    const [triangle, second, third] = parts.subarray(PART_FLOATS * i, PART_FLOATS * (i + 1));
    const [a, b, c] = [0, 1, 2].map((k) => at(3 * triangle + k));
    return a.map((x, k) => x * (1 - second - third) + b[k] * second + c[k] * third);
  });
}

describe('triangles divided for shadow maps', () => {
  const mesh = box([4, 2, 1]);
  const radius = Math.hypot(2, 1, 0.5);
  const parts = dividedTriangles(arraysOf(mesh), () => radius);
  if (!parts) throw new Error('nothing was divided');
  const corners = cornersOf(mesh, parts);

  it('have short edges and the same area', () => {
    let area = 0;
    for (let i = 0; i < corners.length; i += 3) {
      const [a, b, c] = corners.slice(i, i + 3);
      const [p, q] = [b, c].map((to) => to.map((x, k) => x - a[k]));
      for (const edge of [p, q, p.map((x, k) => x - q[k])]) expect(Math.hypot(...edge)).toBeLessThan(radius / 16);
      area += Math.hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]) / 2;
    }
    expect(area).toBeCloseTo(2 * (8 + 4 + 2), 6);
  });

  it('have no gaps: every edge of a closed surface belongs to two of them', () => {
    const edges = new Map<string, number>();
    const name = (corner: number[]) => corner.map((x) => (Math.round(1e6 * x) / 1e6 + 0).toFixed(6)).join();
    for (let i = 0; i < corners.length; i += 3)
      for (const [a, b] of [
        [0, 1],
        [1, 2],
        [2, 0],
      ]) {
        const key = [name(corners[i + a]), name(corners[i + b])].sort().join(' ');
        edges.set(key, (edges.get(key) ?? 0) + 1);
      }
    expect([...new Set(edges.values())]).toEqual([2]);
  });

  it('are none of fine meshes, and not too many of any', () => {
    const fine = grid(1, 1, 40, 40);
    expect(dividedTriangles(arraysOf(fine), () => 0.7)).toBeUndefined();
    const tiny = dividedTriangles(arraysOf(mesh), () => 1e-3);
    expect(tiny?.length).toBeLessThanOrEqual(3 * PART_FLOATS * 2 ** 14);
    expect(dividedTriangles(arraysOf(mesh), () => 0)).toBeUndefined();
    const endless = {
      ...arraysOf(mesh),
      positions: mesh.positions.map((x, i) => (i % 9 === 0 ? Number.POSITIVE_INFINITY : x)),
    };
    expect(() => dividedTriangles(endless, () => 1)).not.toThrow();
    const broken = { ...arraysOf(mesh), positions: mesh.positions.map(() => Number.NaN) };
    expect(dividedTriangles(broken, () => 1)).toBeUndefined();
  });
});
