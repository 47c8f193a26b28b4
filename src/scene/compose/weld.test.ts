import { describe, expect, it } from 'vitest';
import { lattice } from '../mesh/lattice.ts';
import { box, grid, sphere } from '../mesh/primitives.ts';
import type { Mesh } from '../types.ts';
import { recoverQuads } from './recoverQuads.ts';
import { weld } from './weld.ts';

const facesOf = (mesh: Mesh, within = 0) => {
  const { pointOfVertex, vertexOfPoint } = weld(mesh.positions, within);
  const points = Array.from(vertexOfPoint, (v) => [...mesh.positions.subarray(3 * v, 3 * v + 3)]);
  const triangles = Array.from(mesh.indices, (v) => pointOfVertex[v]);
  return { points, ...recoverQuads(points.flat(), triangles) };
};

describe('welding', () => {
  it('joins vertices that were split by normals and uvs', () => {
    expect(facesOf(box([1, 2, 3])).points).toHaveLength(8);
    const round = sphere(1, { segments: 12, rings: 6 });
    expect(facesOf(round).points).toHaveLength(2 + 12 * 5);
    expect(round.positions.length / 3).toBeGreaterThan(2 + 12 * 5);
  });

  it('joins points that differ by rounding only, and none farther apart', () => {
    const positions = Float32Array.of(0, 0, 0, 1e-7, -1e-7, 0, 0.1, 0, 0, 0.1, 1e-7, 1e-7, 0.1003, 0, 0);
    expect([...weld(positions, 1e-6).pointOfVertex]).toEqual([0, 0, 1, 1, 2]);
    expect([...weld(positions).pointOfVertex]).toEqual([0, 1, 2, 3, 4]);
    // Bars and nodes of a lattice are created separately; the 8 corners of each node are all its points.
    expect(facesOf(lattice([2, 1, 1], 1, 0.1), 1e-6).points).toHaveLength(8 * 3 * 2 * 2);
  });
});

describe('faces', () => {
  it('of a triangulated grid are its cells, each with its corners in order', () => {
    const { points, counts, corners } = facesOf(grid(2, 3, 4, 6));
    expect(counts).toEqual(new Array(24).fill(4));
    for (let f = 0; f < 24; f++) {
      const [a, b, c, d] = corners.slice(4 * f, 4 * f + 4).map((i) => points[i]);
      // Twice the area, by the diagonals, is that of two cells of half a metre: so no face intersects itself.
      const [p, q] = [c.map((x, k) => x - a[k]), d.map((x, k) => x - b[k])];
      expect(Math.abs(p[0] * q[1] - p[1] * q[0])).toBeCloseTo(2 * 0.5 * 0.5, 6);
    }
  });

  it('stay triangles where the surface bends, and where no side is the longest', () => {
    const bent = [0, 0, 0, 1, 0, 0, 1, 1, 0.1, 0, 1, 0];
    expect(recoverQuads(bent, [0, 1, 2, 0, 2, 3]).counts).toEqual([3, 3]);
    const h = Math.sqrt(3) / 2;
    const even = [0, 0, 0, 1, 0, 0, 0.5, h, 0, 1.5, h, 0];
    expect(recoverQuads(even, [0, 1, 2, 1, 3, 2]).counts).toEqual([3, 3]);
    expect(recoverQuads([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 1, 0, 1, 2]).counts).toEqual([3]);
  });
});
