import { describe, expect, it } from 'vitest';
import { makeMesh } from '../mesh/makeMesh.ts';
import type { Polygons, PolygonValues } from '../mesh/polygons.ts';
import type { FaceVaryingRule } from './faceVarying.ts';
import { boundaryFaces, type SubdivisionOptions, subdividePolygons } from './subdividePolygons.ts';
import { makeTopology } from './topology.ts';

/** A sheet of n × n squares, 1 wide each. */
const sheet = (n: number): Polygons => ({
  points: Array.from({ length: (n + 1) ** 2 }, (_, p) => [p % (n + 1), Math.floor(p / (n + 1)), 0]).flat(),
  faceCounts: Array(n * n).fill(4),
  faceIndices: Array.from({ length: n * n }, (_, f) => {
    const p = (f % n) + (n + 1) * Math.floor(f / n);
    return [p, p + 1, p + n + 2, p + n + 1];
  }).flat(),
});
const how: SubdivisionOptions = {
  scheme: 'catmullClark',
  levels: 2,
  faceVarying: 'cornersPlus1',
  smoothTriangles: false,
  hidden: () => false,
};
function subdivided(cage: Polygons, rest: Partial<SubdivisionOptions> = {}) {
  const topology = makeTopology({ ...cage, points: cage.points.length / 3, sharpCorners: true });
  return subdividePolygons(cage, topology, { ...how, ...rest });
}
/** Value and position of each corner. */
function corners(polygons: Polygons, of: 'uvs' | 'colors', width: number): { at: number[]; value: number[] }[] {
  const { per, values, indices } = polygons[of]!;
  return Array.from(polygons.faceIndices as Uint32Array, (slot, c) => {
    const place = per === 'corner' ? c : Math.floor(c / 4);
    const i = indices ? indices[place] : place;
    const points = polygons.points as Float32Array;
    return {
      at: [...points.subarray(3 * slot, 3 * slot + 2)],
      value: Array.from({ length: width }, (_, k) => values[i * width + k]),
    };
  });
}
const perPoint = (cage: Polygons, of: (x: number, y: number) => number[], linear = false): PolygonValues => ({
  per: 'point',
  values: Array.from({ length: cage.points.length / 3 }, (_, p) =>
    of(cage.points[3 * p], cage.points[3 * p + 1]),
  ).flat(),
  linear,
});

describe('values on a subdivided mesh', () => {
  it('of points are subdivided like the points, or linearly', () => {
    const cage = sheet(4);
    const square = (x: number, y: number): number[] => [x * x, y, 0];
    for (const linear of [false, true]) {
      const { polygons } = subdivided({ ...cage, colors: perPoint(cage, square, linear) });
      for (const { at, value } of corners(polygons, 'colors', 3)) {
        expect(value[1]).toBeCloseTo(at[1], 6);
        // A cubic B-spline of x² is x² + 1/3 away from the ends; linear interpolation overshoots by s(1 − s).
        const [x, s] = [at[0], at[0] % 1];
        if (!linear && x >= 1 && x <= 3) expect(value[0]).toBeCloseTo(x * x + 1 / 3, 5);
        if (linear && x >= 1 && x <= 3) expect(value[0]).toBeCloseTo(x * x + s * (1 - s), 5);
      }
    }
  });

  it('of faces and materials stay with the faces', () => {
    const cage: Polygons = {
      ...sheet(2),
      faceMaterials: [5, 6, 7, 8],
      colors: { per: 'face', values: [1, 0, 0, 0, 1, 0], indices: [0, 1, 1, 0] },
    };
    const { polygons } = subdivided(cage, { levels: 1 });
    expect([...(polygons.faceMaterials as Uint32Array)]).toEqual([5, 6, 7, 8].flatMap((m) => Array(4).fill(m)));
    expect(corners(polygons, 'colors', 3)[16 * 1].value).toEqual([0, 1, 0]);
    expect(corners(polygons, 'colors', 3)[16 * 3].value).toEqual([1, 0, 0]);
  });

  it('hidden faces shape their neighbours, and are skipped with their values', () => {
    const cage = { ...sheet(4), uvs: perPoint(sheet(4), (x, y) => [x, y]) };
    const whole = subdivided(cage);
    const some = subdivided(cage, { hidden: (f) => f === 5 });
    expect(some.polygons.faceCounts.length).toBe(whole.polygons.faceCounts.length - 16);
    const at = (p: Polygons): Set<string> => new Set(corners(p, 'uvs', 2).map(({ at, value }) => `${at} ${value}`));
    for (const corner of at(some.polygons)) expect(at(whole.polygons)).toContain(corner);
    expect(makeMesh(some.polygons).mesh.indices.length).toBe((256 - 16) * 6);
  });

  it('left-handed faces have their normals on the side from which they run clockwise', () => {
    const { mesh } = makeMesh(subdivided({ ...sheet(2), leftHanded: true }).polygons);
    expect([...mesh.normals.subarray(0, 3)].map((x) => x + 0)).toEqual([0, 0, -1]);
    const [a, b, c] = mesh.indices;
    const p = (v: number, k: number): number => mesh.positions[3 * v + k];
    expect((p(b, 0) - p(a, 0)) * (p(c, 1) - p(a, 1)) - (p(c, 0) - p(a, 0)) * (p(b, 1) - p(a, 1))).toBeLessThan(0);
  });
});

describe('values on corners', () => {
  /** u = x; the left half of the sheet has v = y, the right half v = y + 10: a seam runs through the middle. */
  const seam = (): Polygons => {
    const cage = sheet(4);
    const uvs = Array.from(cage.faceIndices as number[], (p, c) => {
      const [x, y] = [cage.points[3 * p], cage.points[3 * p + 1]];
      return [x * x, y + (Math.floor(c / 4) % 4 < 2 ? 0 : 10)];
    });
    return { ...cage, uvs: { per: 'corner', values: uvs.flat() } };
  };
  const uAt = (rule: FaceVaryingRule, x: number, y: number, right: boolean): number => {
    const found = corners(subdivided(seam(), { faceVarying: rule }).polygons, 'uvs', 2).find(
      ({ at, value }) => Math.hypot(at[0] - x, at[1] - y) < 1e-6 && value[1] >= 5 === right,
    );
    return found!.value[0];
  };

  it('are discontinuous at a seam, and smooth within the pieces', () => {
    const { polygons } = subdivided(seam());
    const onSeam = corners(polygons, 'uvs', 2).filter(({ at }) => at[0] === 2);
    expect(new Set(onSeam.map(({ value }) => value[1] >= 5)).size).toBe(2);
    for (const { at, value } of corners(polygons, 'uvs', 2)) {
      expect(value[1] - (value[1] >= 5 ? 10 : 0)).toBeCloseTo(at[1], 5);
      if (at[0] === 1) expect(value[0]).toBeCloseTo(1 + 1 / 3, 5);
    }
  });

  it.each([
    // At (2, 0) two pieces meet at the rim, each with one face there: a corner of each. u = 4 is kept, or smoothed by u(1, 0) and u(2, 1).
    ['none', 2, 0, (4 * 4 + 1 + 4) / 6],
    ['cornersOnly', 2, 0, 4],
    ['cornersPlus1', 2, 0, 4],
    ['boundaries', 2, 0, 4],
    ['all', 2, 0, 4],
    // Inside, x² becomes x² + 1/3, but not where all is linear.
    ['none', 1, 2, 1 + 1 / 3],
    ['cornersPlus1', 1, 2, 1 + 1 / 3],
    ['all', 1, 2, 1],
  ] as const)('%s at (%i, %i): u = %f', (rule, x, y, expected) => {
    expect(uAt(rule, x, y, false)).toBeCloseTo(expected, 5);
  });

  it('are pinned, depending on the rule, where three pieces meet, where a seam ends, and at corners', () => {
    // Four squares around a point, each value given by the pieces of its faces.
    const at = (pieces: readonly number[], rule: FaceVaryingRule): number => {
      const cage = sheet(2);
      const uvs = Array.from(cage.faceIndices as number[], (p, c) => {
        const [x, y] = [cage.points[3 * p], cage.points[3 * p + 1]];
        return [
          (x - 1) ** 2 + (y - 1) ** 2,
          p === 4 ? (Math.max(...pieces) === 9 ? 0 : pieces[Math.floor(c / 4)]) : pieces[Math.floor(c / 4)],
        ];
      });
      const { polygons } = subdivided({ ...cage, uvs: { per: 'corner', values: uvs.flat() } }, { faceVarying: rule });
      // Of the third face, at the middle of the sheet.
      return corners(polygons, 'uvs', 2)
        .slice(2 * 64)
        .find(({ at: [x, y] }) => x === 1 && y === 1)!.value[0];
    };
    const rules = ['none', 'cornersOnly', 'cornersPlus1', 'cornersPlus2'] as const;
    const pinned = (pieces: readonly number[]): boolean[] => rules.map((rule) => at(pieces, rule) === 0);
    // Third face: with the fourth one piece, the others two.
    expect(pinned([1, 2, 3, 3])).toEqual([false, false, true, true]);
    // Two pieces of two faces.
    expect(pinned([1, 1, 3, 3])).toEqual([false, false, false, false]);
    // The other piece has one face only.
    expect(pinned([1, 3, 3, 3])).toEqual([false, false, false, true]);
    // All alike: nothing is pinned.
    expect(pinned([1, 1, 1, 1])).toEqual([false, false, false, false]);
  });
});

describe('boundaryFaces', () => {
  it('are those with a boundary point, unless their boundary is marked as sharp', () => {
    const cage = sheet(4);
    const topology = makeTopology({ ...cage, points: 25, sharpCorners: false });
    expect([...boundaryFaces(topology, () => 0)].filter((x) => x === 0).length).toBe(4);
    expect([...boundaryFaces(topology, () => 10)].every((x) => x === 0)).toBe(true);
  });
});
