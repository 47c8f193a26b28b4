import { describe, expect, it } from 'vitest';
import { addScaled, cross, distance, dot, sub, type Vec3 } from '../../math/vec3.ts';
import { makeMesh } from '../mesh/makeMesh.ts';
import { type Polygons, pointAt } from '../mesh/polygons.ts';
import { distanceFromLimit } from './flatness.ts';
import { type SubdivisionOptions, subdividePolygons } from './subdividePolygons.ts';
import { makeTopology } from './topology.ts';

type Cage = Pick<Polygons, 'points' | 'faceCounts' | 'faceIndices'>;

/** Quads over a grid of columns and rows; `ring` joins the last column to the first. */
function grid(columns: number, rows: number, place: (i: number, j: number) => Vec3, ring = false): Cage {
  const across = ring ? columns : columns + 1;
  const at = (i: number, j: number): number => (i % across) + across * j;
  const cells = Array.from({ length: columns * rows }, (_, f) => [f % columns, Math.floor(f / columns)]);
  return {
    points: Array.from({ length: across * (rows + 1) }, (_, p) => place(p % across, Math.floor(p / across))).flat(),
    faceCounts: cells.map(() => 4),
    faceIndices: cells.flatMap(([i, j]) => [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]),
  };
}

const around = (i: number, n: number, r: number, z: number): Vec3 => [
  r * Math.cos((2 * Math.PI * i) / n),
  r * Math.sin((2 * Math.PI * i) / n),
  z,
];

const CAGES: Readonly<Record<string, Cage>> = {
  cube: {
    points: [-1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1, -1, 1, -1, 1, 1, -1, -1, -1, -1, 1, -1, -1],
    faceCounts: Array(6).fill(4),
    faceIndices: [0, 1, 3, 2, 2, 3, 5, 4, 4, 5, 7, 6, 6, 7, 1, 0, 1, 7, 5, 3, 6, 0, 2, 4],
  },
  tube: grid(8, 3, (i, j) => around(i, 8, 1, j), true),
  // Its points stay where they are on the limit surface, nearly.
  saddle: grid(5, 5, (i, j) => [i, j, 0.2 * ((i - 2.5) ** 2 - (j - 2.5) ** 2)]),
  bowl: grid(5, 5, (i, j) => [i, j, 0.2 * ((i - 2.5) ** 2 + (j - 2.5) ** 2)]),
  twisted: grid(4, 4, (i, j) => [i, j, 0.3 * (i - 2) * (j - 2)]),
  // Rows that lie unevenly.
  vase: grid(10, 4, (i, j) => around(i, 10, [1, 1.3, 0.6, 0.5, 0.8][j], [0, 0.2, 1.5, 1.6, 2.4][j]), true),
  // Its faces are hexagons, with triangles about them.
  prism: {
    points: [0, 1].flatMap((z) => Array.from({ length: 6 }, (_, i) => around(i, 6, 1, z)).flat()),
    faceCounts: [6, 6, ...Array(6).fill(4)],
    faceIndices: [
      ...[5, 4, 3, 2, 1, 0],
      ...[6, 7, 8, 9, 10, 11],
      ...[0, 1, 2, 3, 4, 5].flatMap((i) => [i, (i + 1) % 6, 6 + ((i + 1) % 6), 6 + i]),
    ],
  },
};

const OCTAHEDRON: Cage = {
  points: [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1],
  faceCounts: Array(8).fill(3),
  faceIndices: [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5],
};

function subdivided(cage: Cage, scheme: SubdivisionOptions['scheme'], levels: number) {
  const topology = makeTopology({ ...cage, points: cage.points.length / 3, sharpCorners: true });
  const how = { scheme, levels, faceVarying: 'cornersPlus1', smoothTriangles: false, hidden: () => false } as const;
  return { topology, mesh: makeMesh(subdividePolygons(cage, topology, how).polygons).mesh };
}

/** Distance of a point from a triangle: of its foot if that is inside, else of the edges. */
function fromTriangle(p: Vec3, [a, b, c]: readonly Vec3[]): number {
  const normal = cross(sub(b, a), sub(c, a));
  const sides = [
    [a, b],
    [b, c],
    [c, a],
  ] as const;
  if (sides.every(([from, to]) => dot(cross(sub(to, from), sub(p, from)), normal) >= 0))
    return Math.abs(dot(sub(p, a), normal)) / Math.sqrt(dot(normal, normal));
  const fromSegment = ([from, to]: readonly [Vec3, Vec3]): number => {
    const along = sub(to, from);
    const s = Math.min(1, Math.max(0, dot(sub(p, from), along) / dot(along, along)));
    return distance(p, addScaled(from, along, s));
  };
  return Math.min(...sides.map(fromSegment));
}

/** The greatest distance of the limit surface, at the points of two more levels, from a mesh. */
function measured(cage: Cage, scheme: SubdivisionOptions['scheme'], levels: number): number {
  const { positions, indices } = subdivided(cage, scheme, levels).mesh;
  const triangles = Array.from({ length: indices.length / 3 }, (_, t) =>
    [0, 1, 2].map((k) => pointAt(positions, indices[3 * t + k])),
  );
  const fine = subdivided(cage, scheme, levels + 2).mesh.positions;
  let most = 0;
  for (let v = 0; v < fine.length / 3; v++) {
    const place = pointAt(fine, v);
    most = Math.max(
      most,
      triangles.reduce((least, t) => Math.min(least, fromTriangle(place, t)), Infinity),
    );
  }
  return most;
}

describe('the distance from the limit surface', () => {
  const cases = [
    ...Object.entries(CAGES).map(([name, cage]) => [name, cage, 'catmullClark'] as const),
    ['octahedron', OCTAHEDRON, 'loop'] as const,
  ];
  it.each(cases)('of a %s is about what is measured, with no level and with one', (_, cage, scheme) => {
    const { topology } = subdivided(cage, scheme, 1);
    const estimate = distanceFromLimit(topology, cage.points);
    for (const levels of [0, 1]) {
      const share = (measured(cage, scheme, levels) * 4 ** levels) / estimate;
      expect(share).toBeGreaterThan(0.5);
      expect(share).toBeLessThan(1.4);
    }
  });
});
