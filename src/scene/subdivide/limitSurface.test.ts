import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { LimitSurface, limitValues, parentFaces, refineTopology } from './limitSurface.ts';
import { facesAfter, type SubdivisionScheme } from './scheme.ts';
import { type ControlCage, makeTopology, type SubdivisionTopology } from './topology.ts';

interface Shape {
  readonly points: readonly (readonly number[])[];
  readonly faces: readonly (readonly number[])[];
}

const cageOf = ({ points, faces }: Shape, rest: Partial<ControlCage> = {}): SubdivisionTopology =>
  makeTopology({
    points: points.length,
    faceCounts: faces.map((f) => f.length),
    faceIndices: faces.flat(),
    sharpCorners: true,
    ...rest,
  });
const surfaceOf = (
  shape: Shape,
  levels: number,
  rest: Partial<ControlCage> = {},
  scheme: SubdivisionScheme = 'catmullClark',
) => new LimitSurface(refineTopology(cageOf(shape, rest), scheme, levels));
const expectNear = (actual: readonly number[], expected: readonly number[], digits: number, what?: string): void => {
  for (const [k, x] of expected.entries()) expect(actual[k], what).toBeCloseTo(x, digits);
};
const at = (values: ArrayLike<number>, i: number): number[] => [values[3 * i], values[3 * i + 1], values[3 * i + 2]];
const sharpBetween =
  (edges: readonly (readonly number[])[], sharpness: number) =>
  (a: number, b: number): number =>
    edges.some(([p, q]) => (p === a && q === b) || (p === b && q === a)) ? sharpness : 0;

const cube: Shape = {
  points: Array.from({ length: 8 }, (_, i) => [i & 1, (i >> 1) & 1, i >> 2].map((x) => 2 * x - 1)),
  faces: [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ],
};
const octahedron: Shape = {
  points: [
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1, 0],
    [0, -1, 0],
    [0, 0, 1],
    [0, 0, -1],
  ],
  faces: [
    [0, 2, 4],
    [2, 1, 4],
    [1, 3, 4],
    [3, 0, 4],
    [2, 0, 5],
    [1, 2, 5],
    [3, 1, 5],
    [0, 3, 5],
  ],
};
/** A pentagonal pyramid: a pentagon, a point of valence 5, five of valence 3. */
const pyramid: Shape = {
  points: [
    ...Array.from({ length: 5 }, (_, i) => [Math.cos((2 * Math.PI * i) / 5), Math.sin((2 * Math.PI * i) / 5), 0]),
    [0.1, 0.2, 1.5],
  ],
  faces: [[4, 3, 2, 1, 0], ...Array.from({ length: 5 }, (_, i) => [i, (i + 1) % 5, 5])],
};
/** Triangles around the middle of a straight edge. */
const fanOf = (n: number): Shape => ({
  points: [
    [0, 0, 0.3],
    ...Array.from({ length: n + 1 }, (_, i) => [
      Math.cos((Math.PI * i) / n),
      Math.sin((Math.PI * i) / n),
      Math.sin(2 * i),
    ]),
  ],
  faces: Array.from({ length: n }, (_, i) => [0, i + 1, i + 2]),
});
const N = 5;
const grid = (height: (i: number, j: number) => number): Shape => ({
  points: Array.from({ length: N * N }, (_, p) => [p % N, Math.floor(p / N), height(p % N, Math.floor(p / N))]),
  faces: Array.from({ length: (N - 1) ** 2 }, (_, f) => {
    const p = (f % (N - 1)) + N * Math.floor(f / (N - 1));
    return [p, p + 1, p + 1 + N, p + N];
  }),
});
const hills = grid((i, j) => Math.sin(2 * i + 1) * Math.cos(3 * j) + 0.2 * i * j);

/** The uniform cubic B-spline and its slope (de Boor 1978). */
const spline = (x: number): number => {
  const r = Math.abs(x);
  return r >= 2 ? 0 : r >= 1 ? (2 - r) ** 3 / 6 : 2 / 3 - r * r + r ** 3 / 2;
};
const slope = (x: number): number => {
  const r = Math.abs(x);
  return Math.sign(x) * (r >= 2 ? 0 : r >= 1 ? -((2 - r) ** 2) / 2 : -2 * r + 1.5 * r * r);
};
/** Spline height from control heights on the grid, extrapolated linearly by one row. */
function splineHeight(shape: Shape, x: number, y: number, bx = spline, by = spline): number {
  const inside = (i: number): readonly (readonly [number, number])[] =>
    i < 0
      ? [
          [0, 2],
          [1, -1],
        ]
      : i >= N
        ? [
            [N - 1, 2],
            [N - 2, -1],
          ]
        : [[i, 1]];
  let sum = 0;
  for (let j = -1; j <= N; j++)
    for (let i = -1; i <= N; i++)
      for (const [q, v] of inside(j))
        for (const [p, u] of inside(i)) sum += u * v * bx(x - i) * by(y - j) * shape.points[p + N * q][2];
  return sum;
}

describe('a regular grid', () => {
  it.each([1, 2, 3])('is the bicubic B-spline, to its boundary and corners, at level %i', (levels) => {
    const surface = surfaceOf(hills, levels);
    const { positions, normals } = surface.at(hills.points.flat());
    expect(positions.length / 3).toBe(((N - 1) * 2 ** levels + 1) ** 2);
    for (let s = 0; s < positions.length / 3; s++) {
      const [x, y, z] = at(positions, s);
      expect(z).toBeCloseTo(splineHeight(hills, x, y), 6);
      const [dx, dy] = [splineHeight(hills, x, y, slope), splineHeight(hills, x, y, spline, slope)];
      const length = Math.hypot(dx, dy, 1);
      const expected = [-dx / length, -dy / length, 1 / length];
      for (let k = 0; k < 3; k++) expect(at(normals, s)[k], `${x} ${y}`).toBeCloseTo(expected[k], 5);
    }
  });

  it('without sharp boundary corners has a smooth boundary curve', () => {
    const positions = surfaceOf(hills, 2, { sharpCorners: false }).at(hills.points.flat()).positions;
    const [p, a, b] = [hills.points[0], hills.points[1], hills.points[N]];
    expectNear(
      at(positions, 0),
      p.map((x, k) => (4 * x + a[k] + b[k]) / 6),
      6,
    );
  });
});

describe('limit masks', () => {
  it('move the corner of a cube to (3 p + Σ edges 4/8 + Σ diagonals 1/8) / 8', () => {
    const { positions } = surfaceOf(cube, 2).at(cube.points.flat());
    // Halstead et al. (1993): n/(n+5), 4/(n(n+5)), 1/(n(n+5)) for n = 3; by symmetry on the diagonal.
    const expected = 3 / 8 + (4 / 24) * (1 + 1 - 1) + (1 / 24) * (1 - 1 - 1);
    expect(at(positions, 7).map(Math.abs)).toEqual(Array(3).fill(Math.fround(expected)));
  });

  it('make a sharp loop the cubic B-spline curve of its points', () => {
    const loop = [
      [4, 5],
      [5, 7],
      [7, 6],
      [6, 4],
    ];
    const surface = surfaceOf(cube, 3, { creaseSharpness: sharpBetween(loop, 10) });
    const { positions } = surface.at(cube.points.flat());
    const places = Array.from({ length: surface.slots }, (_, s) => at(positions, s));
    const onTop = places.filter((p) => Math.abs(p[2] - 1) < 1e-6 && Math.max(Math.abs(p[0]), Math.abs(p[1])) > 0.6);
    const ring = [4, 5, 7, 6].map((p) => cube.points[p]);
    for (let i = 0; i < 32; i++) {
      const u = i / 8;
      const point = [0, 1].map((k) =>
        ring.reduce((sum, p, j) => sum + p[k] * [-4, 0, 4].reduce((w, wrap) => w + spline(u - j + wrap), 0), 0),
      );
      const nearest = Math.min(...onTop.map((p) => Math.hypot(p[0] - point[0], p[1] - point[1])));
      expect(nearest).toBeLessThan(1e-6);
    }
  });

  const cases: [string, Shape, Partial<ControlCage>, SubdivisionScheme][] = [
    ['a cube', cube, {}, 'catmullClark'],
    ['a pyramid', pyramid, {}, 'catmullClark'],
    ['an open pyramid', { ...pyramid, faces: pyramid.faces.slice(1) }, {}, 'catmullClark'],
    [
      'a crease around it',
      pyramid,
      {
        creaseSharpness: sharpBetween(
          [0, 1, 2, 3, 4].map((i) => [i, (i + 1) % 5]),
          10,
        ),
      },
      'catmullClark',
    ],
    ['a sharp tip', pyramid, { pointSharpness: Float64Array.of(0, 0, 0, 0, 0, 10) }, 'catmullClark'],
    ['hills', hills, {}, 'catmullClark'],
    ['an octahedron', octahedron, {}, 'loop'],
    ['an open octahedron', { ...octahedron, faces: octahedron.faces.slice(0, 7) }, {}, 'loop'],
    ['half an octahedron', { ...octahedron, faces: octahedron.faces.slice(0, 4) }, { sharpCorners: false }, 'loop'],
    ...[3, 4, 7].flatMap((n): [string, Shape, Partial<ControlCage>, SubdivisionScheme][] => [
      [`a fan of ${n}`, fanOf(n), { sharpCorners: false }, 'catmullClark'],
      [`a fan of ${n} triangles`, fanOf(n), { sharpCorners: false }, 'loop'],
    ]),
    ['flat hills', hills, {}, 'bilinear'],
  ];
  it.each(cases)('of %s do not depend on the level', (_, shape, rest, scheme) => {
    const points = shape.points.flat();
    const [coarse, fine] = [2, 3].map((levels) => surfaceOf(shape, levels, rest, scheme));
    const [a, b] = [coarse.at(points), fine.at(points)];
    const { corners, pointSharpness } = coarse.refinement.topology;
    for (let c = 0; c < corners.length; c++) {
      const child = scheme === 'loop' ? 12 * Math.floor(c / 3) + 3 * (c % 3) : 4 * c;
      const [s, t] = [coarse.slotOfCorner[c], fine.slotOfCorner[child]];
      expectNear(at(b.positions, t), at(a.positions, s), 6);
      // A fixed smooth point is the tip of a cone and has no unique normal.
      if (pointSharpness[corners[c]] > 0 && shape === pyramid) continue;
      expectNear(at(b.normals, t), at(a.normals, s), 5, `corner ${c}`);
    }
  });
});

describe('sharpness', () => {
  const rim = [0, 1, 2, 3, 4].map((i) => [i, (i + 1) % 5]);
  const refined = (levels: number, sharpness: number): number[] =>
    [...refineOnce(pyramid, levels, { creaseSharpness: sharpBetween(rim, sharpness) }).points].flat();
  /** The refined mesh itself: the bilinear limit leaves values in place. */
  function refineOnce(shape: Shape, levels: number, rest: Partial<ControlCage>): Shape {
    const refinement = refineTopology(cageOf(shape, rest), 'catmullClark', levels);
    const moved = limitValues({ ...refinement, scheme: 'bilinear' }, shape.points.flat(), 3);
    const { corners, points } = refinement.topology;
    return {
      points: Array.from({ length: points }, (_, p) => at(moved, p)),
      faces: Array.from({ length: corners.length / 4 }, (_, f) => [...corners.subarray(4 * f, 4 * f + 4)]),
    };
  }

  it('of 2 is sharp for two levels, then smooth', () => {
    const sharp = refineOnce(pyramid, 2, { creaseSharpness: sharpBetween(rim, 10) });
    const after = refineOnce(sharp, 1, {}).points.flat();
    const direct = refined(3, 2);
    expect(direct.length).toBe(after.length);
    // Points of the second refinement are numbered by its own edges; the old ones keep their numbers.
    for (let i = 0; i < sharp.points.length * 3; i++) expect(direct[i]).toBeCloseTo(after[i], 12);
  });

  it('between 0 and 1 is between smooth and sharp', () => {
    const [none, some, full] = [0, 0.3, 1].map((s) => refined(1, s));
    expectNear(
      some,
      none.map((x, i) => 0.7 * x + 0.3 * full[i]),
      12,
    );
  });

  it('splits the normals, and joins them where it ends', () => {
    const surface = surfaceOf(cube, 2, { creaseSharpness: sharpBetween([[0, 1]], 10) });
    const smooth = surfaceOf(cube, 2);
    // A crease along one edge of four pieces: its three inner points have two normals, its ends one.
    expect(surface.slots).toBe(smooth.slots + 3);
  });
});

describe('every surface', () => {
  const shapes = fc.constantFrom(cube, pyramid, octahedron, hills);
  const number = fc.double({ min: -3, max: 3, noNaN: true });

  it('is affinely invariant', () => {
    fc.assert(
      fc.property(shapes, fc.array(number, { minLength: 12, maxLength: 12 }), (shape, m) => {
        const map = (p: readonly number[]): number[] =>
          [0, 1, 2].map((k) => m[4 * k] * p[0] + m[4 * k + 1] * p[1] + m[4 * k + 2] * p[2] + m[4 * k + 3]);
        const surface = surfaceOf(shape, 2);
        const plain = surface.at(shape.points.flat()).positions;
        const mapped = surface.at(shape.points.flatMap(map)).positions;
        for (let s = 0; s < surface.slots; s++) {
          expectNear(at(mapped, s), map(at(plain, s)), 4);
        }
      }),
      { numRuns: 30 },
    );
  });

  it('lies in the convex hull of its points', () => {
    fc.assert(
      fc.property(shapes, fc.tuple(number, number, number), (shape, d) => {
        const along = (p: readonly number[]): number => p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
        const surface = surfaceOf(shape, 2);
        const { positions } = surface.at(shape.points.flat());
        const most = Math.max(...shape.points.map(along));
        for (let s = 0; s < surface.slots; s++) expect(along(at(positions, s))).toBeLessThanOrEqual(most + 1e-5);
      }),
    );
  });

  it.each([
    ['catmullClark', 3],
    ['bilinear', 2],
    ['loop', 2],
  ] as const)('keeps its Euler characteristic (%s)', (scheme, levels) => {
    for (const shape of scheme === 'loop' ? [octahedron] : [cube, pyramid, octahedron, hills]) {
      const edges = new Set(shape.faces.flatMap((f) => f.map((p, i) => [p, f[(i + 1) % f.length]].sort().join())));
      const { topology } = refineTopology(cageOf(shape), scheme, levels);
      const faces = topology.faceStarts.length - 1;
      expect(topology.points - topology.edgePoints.length / 2 + faces).toBe(
        shape.points.length - edges.size + shape.faces.length,
      );
      expect(faces).toBe(facesAfter(shape.faces.flat().length, scheme, levels));
      expect(Math.max(...topology.cornerEdges)).toBe(topology.edgePoints.length / 2 - 1);
    }
  });

  it('of a closed mesh is closed: every edge has two faces of consistent orientation', () => {
    for (const [shape, scheme] of [
      [pyramid, 'catmullClark'],
      [octahedron, 'loop'],
    ] as const) {
      const { topology: t } = refineTopology(cageOf(shape), scheme, 3);
      t.twins.forEach((twin, c) => {
        expect(t.twins[twin]).toBe(c);
        expect(t.cornerEdges[twin]).toBe(t.cornerEdges[c]);
        expect(t.corners[twin]).not.toBe(t.corners[c]);
        expect([t.edgePoints[2 * t.cornerEdges[c]], t.edgePoints[2 * t.cornerEdges[c] + 1]]).toContain(t.corners[c]);
      });
    }
  });

  it('maps each of its faces to the original face', () => {
    expect([...parentFaces(refineTopology(cageOf(pyramid), 'catmullClark', 1), [5, 3, 3, 3, 3, 3])]).toEqual(
      [5, 3, 3, 3, 3, 3].flatMap((n, f) => Array(n).fill(f)),
    );
  });

  it('has outward normals of length 1', () => {
    const { positions, normals } = surfaceOf(cube, 3).at(cube.points.flat());
    for (let s = 0; s < normals.length / 3; s++) {
      const [p, n] = [at(positions, s), at(normals, s)];
      expect(Math.hypot(...n)).toBeCloseTo(1, 6);
      expect(n[0] * p[0] + n[1] * p[1] + n[2] * p[2]).toBeGreaterThan(0.5);
    }
  });
});

describe('non-manifold meshes', () => {
  it('three faces at an edge, inconsistent orientations, fans that touch in a point: sharp, finite, in place', () => {
    const shape: Shape = {
      points: [...cube.points, [3, 3, 3], [4, 3, 3], [3, 4, 5]],
      faces: [...cube.faces, [0, 1, 8], [7, 9, 10], [7, 9, 8]],
    };
    const surface = surfaceOf(shape, 2);
    const { positions, normals } = surface.at(shape.points.flat());
    expect([...positions, ...normals].every(Number.isFinite)).toBe(true);
    const { corners } = surface.refinement.topology;
    const place = at(positions, surface.slotOfCorner[corners.indexOf(7)]);
    expect(place).toEqual([1, 1, 1]);
  });

  it('have normals where points coincide', () => {
    const flat: Shape = { points: hills.points.map(([x, y]) => [Math.max(1, x), y, 0]), faces: hills.faces };
    const { normals } = surfaceOf(flat, 2).at(flat.points.flat());
    for (let s = 0; s < normals.length / 3; s++)
      expect(at(normals, s)).toEqual([expect.closeTo(0), expect.closeTo(0), 1]);
  });
});
