import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { area, openEdges, polygon, sum, triangles, volume } from '../../tests/support/meshes.ts';
import { distance, length } from '../math/vec3.ts';
import { mergeMeshes } from './meshOps.ts';
import { pointAt } from './polygons.ts';
import { box, cone, plane, sphere } from './primitives.ts';
import { subdivideLongEdges, subdivideObject } from './subdivide.ts';
import type { Mesh, SceneObject } from './types.ts';

describe('subdivideLongEdges', () => {
  const longest = (mesh: Mesh) =>
    Math.max(...triangles(mesh).map(([a, b, c]) => Math.max(distance(a, b), distance(b, c), distance(c, a))));

  it('keeps area, volume and closedness, and leaves no long edge', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0.3, max: 3, noNaN: true }),
        fc.tuple(fc.double({ min: 0.5, max: 8, noNaN: true }), fc.double({ min: 0.5, max: 8, noNaN: true })),
        (maxEdge, [x, y]) => {
          const from = mergeMeshes([box([x, y, 1]), cone(x, y, { segments: 6 })]);
          const { result, stoppedByBudget, longestEdge } = subdivideLongEdges(from, maxEdge, 1e6);
          expect(stoppedByBudget).toBe(false);
          // Edges of the mesh are no longer than asked, those between them about √2 times that.
          expect(longestEdge).toBeLessThanOrEqual(maxEdge);
          expect(longest(result)).toBeLessThanOrEqual(1.5 * maxEdge);
          expect(area(result) / area(from)).toBeCloseTo(1, 4);
          expect(volume(result) / volume(from)).toBeCloseTo(1, 4);
          expect(openEdges(result)).toBe(openEdges(from));
          expect(sum(result.groups.map((g) => g.count))).toBe(result.indices.length);
        },
      ),
      { numRuns: 12 },
    );
  });

  it('two meshes that share an edge agree on its points though their other edges differ', () => {
    const flat = polygon([
      [0, 0],
      [10, 0],
      [10, 0.1],
    ]);
    const tall = polygon([
      [10, 0],
      [0, 0],
      [3, -40],
    ]);
    const onEdge = (mesh: Mesh) =>
      [
        ...new Set(
          triangles(subdivideLongEdges(mesh, 0.7, 1e6).result)
            .flat()
            .filter((p) => p[1] === 0)
            .map((p) => p[0]),
        ),
      ].sort((a, b) => a - b);
    expect(onEdge(flat)).toEqual(onEdge(tall));
    expect(onEdge(flat).length).toBe(16);
  });

  it('makes one strip of a sliver', () => {
    const bar = box([64, 0.1, 0.1]);
    const { result } = subdivideLongEdges(bar, 1, 1e6);
    // Four long faces of two triangles, each with two long edges of 64 pieces (or 65: the diagonal); two small faces.
    expect(result.indices.length / 3).toBeLessThanOrEqual(8 * 2 * 65 + 4);
    expect(openEdges(result)).toBe(0);
    expect(volume(result)).toBeCloseTo(0.64, 6);
  });

  it('stops before the budget, whole and even, and says so', () => {
    const from = box([8, 8, 8]);
    const { result, stoppedByBudget, longestEdge } = subdivideLongEdges(from, 0.01, 1000);
    expect(stoppedByBudget).toBe(true);
    expect(result.indices.length / 3).toBeLessThanOrEqual(1000);
    expect(result.indices.length / 3).toBeGreaterThan(250);
    expect(openEdges(result)).toBe(0);
    expect(longest(result)).toBeLessThanOrEqual(1.5 * longestEdge);
  });

  it('interpolates uv and colour, keeps normals unit, and leaves a fine mesh alone', () => {
    const from: Mesh = { ...plane(4, 2), colors: Float32Array.from([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]) };
    const { result } = subdivideLongEdges(from, 0.5, 1e5);
    for (let v = 0; v < result.positions.length / 3; v++) {
      expect(result.uvs[2 * v]).toBeCloseTo(result.positions[3 * v] / 4 + 0.5, 6);
      expect(result.colors![3 * v]).toBeCloseTo(result.uvs[2 * v], 6);
    }
    const ball = subdivideLongEdges(sphere(1, { segments: 12 }), 0.2, 1e5).result;
    for (let v = 0; v < ball.normals.length / 3; v++) expect(length(pointAt(ball.normals, v))).toBeCloseTo(1, 6);
    expect(subdivideLongEdges(from, 10, 1e5).result.indices).toBe(from.indices);
  });

  it('a deforming object is cut where it is ever long, and its samples follow', () => {
    const mesh = plane(1, 1);
    const stretched = Float32Array.from(mesh.positions, (x, i) => (i % 3 === 0 ? 8 * x : x));
    const object: SceneObject = {
      path: '/Sheet',
      mesh,
      motion: {
        kind: 'sampled-points',
        times: Float64Array.of(0, 1),
        origin: [0, 0, 0],
        points: [mesh.positions, stretched],
        normals: [mesh.normals, mesh.normals],
      },
      lifetime: { birth: Number.NEGATIVE_INFINITY, death: Number.POSITIVE_INFINITY },
      authoredIn: 'world',
    };
    const { result } = subdivideObject(object, 1.2, 1e5);
    if (result.motion.kind !== 'sampled-points') throw new Error('motion kind changed');
    const [rest, wide] = result.motion.points;
    expect(longest({ ...result.mesh, positions: wide })).toBeLessThanOrEqual(1.5 * 1.2);
    expect([...rest]).toEqual([...result.mesh.positions]);
    rest.forEach((x, i) => {
      expect(wide[i]).toBeCloseTo(i % 3 === 0 ? 8 * x : x, 5);
    });
    expect(result.motion.normals?.[1].length).toBe(wide.length);
  });
});
