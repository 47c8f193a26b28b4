import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  area,
  eulerCharacteristic,
  openEdges,
  polygon,
  sum,
  triangles,
  volume,
} from '../../../tests/support/meshes.ts';
import { fromParts } from '../../math/mat4.ts';
import { fromAxisAngle, rotate, toMatrix } from '../../math/quat.ts';
import { cross, distance, dot, normalize, sub, type Vec3 } from '../../math/vec3.ts';
import { gatherPoints, makeMesh } from './makeMesh.ts';
import { mergeMeshes, transformMesh, withMaterial } from './meshOps.ts';
import { deformedNormals, smoothingGroups } from './normals.ts';
import { pointAt } from './polygons.ts';
import { box, capsule, cone, cylinder, grid, plane, sphere, torus } from './primitives.ts';

describe('primitives', () => {
  const [r, h, n] = [1.5, 4, 24];
  const ngon = (n / 2) * r * r * Math.sin((2 * Math.PI) / n);
  const side = 2 * n * Math.sin(Math.PI / n) * r;
  const apothem = r * Math.cos(Math.PI / n);
  // Volumes and areas of the inscribed polyhedra, from elementary geometry.
  it.each([
    ['box', box([1, 2, 3]), 2, 6, 22],
    ['cylinder', cylinder(r, h, { segments: n }), 2, ngon * h, 2 * ngon + side * h],
    ['cone', cone(r, h, { segments: n }), 2, (ngon * h) / 3, ngon + (side / 2) * Math.hypot(h, apothem)],
  ])('%s: exact volume and area, closed, genus 0', (_, mesh, chi, v, a) => {
    expect(openEdges(mesh)).toBe(0);
    expect(eulerCharacteristic(mesh)).toBe(chi);
    expect(volume(mesh)).toBeCloseTo(v, 5);
    expect(area(mesh)).toBeCloseTo(a, 5);
  });

  it.each([
    ['sphere', sphere(r, { segments: 96 }), 2, (4 / 3) * Math.PI * r ** 3, 4 * Math.PI * r * r],
    [
      'capsule',
      capsule(r, h, { segments: 96 }),
      2,
      Math.PI * r * r * h + (4 / 3) * Math.PI * r ** 3,
      2 * Math.PI * r * h + 4 * Math.PI * r * r,
    ],
    ['torus', torus(2, 0.5, { segments: 96, rings: 48 }), 0, 2 * Math.PI ** 2 * 2 * 0.25, 4 * Math.PI ** 2],
  ])('%s: volume and area near those of the smooth body, closed, correct genus', (_, mesh, chi, v, a) => {
    expect(openEdges(mesh)).toBe(0);
    expect(eulerCharacteristic(mesh)).toBe(chi);
    // A chord of angle δ leaves out δ²/6 of the area at most, here δ = 2π/48.
    expect(Math.abs(volume(mesh) / v - 1)).toBeLessThan(0.004);
    expect(Math.abs(area(mesh) / a - 1)).toBeLessThan(0.004);
    expect(volume(mesh)).toBeLessThan(v);
  });

  it('sphere and torus normals are those of the smooth surface', () => {
    const ball = sphere(2);
    for (let v = 0; v < ball.positions.length / 3; v++) {
      const p = pointAt(ball.positions, v);
      // A pole's corners have the normal of their own triangle's middle, which is the pole's own.
      expect(distance(pointAt(ball.normals, v), normalize(p))).toBeLessThan(1e-6);
    }
    const ring = torus(3, 1);
    for (let v = 0; v < ring.positions.length / 3; v++) {
      const [x, y, z] = pointAt(ring.positions, v);
      const center: Vec3 = [(3 * x) / Math.hypot(x, y), (3 * y) / Math.hypot(x, y), 0];
      expect(distance(pointAt(ring.normals, v), sub([x, y, z], center))).toBeLessThan(1e-5);
    }
  });

  it.each(['X', 'Y', 'Z'] as const)('axis %s: a plane faces along it, a cone points along it', (axis) => {
    const along = { X: [1, 0, 0], Y: [0, 1, 0], Z: [0, 0, 1] }[axis] as [number, number, number];
    expect([...plane(1, 2, axis).normals.slice(0, 3)].map((x) => x + 0)).toEqual(along);
    const tip = cone(1, 2, { axis, segments: 8 });
    const tips = triangles(tip)
      .flat()
      .filter((p) => dot(p, along) > 0.5);
    expect(tips.length).toBe(8);
    for (const p of tips) expect(p).toEqual(along);
    expect(volume(tip)).toBeGreaterThan(0);
  });

  it('grid: cells cover the rectangle, and uv is the position in it', () => {
    const mesh = grid(6, 4, 3, 5, 'Y');
    expect(mesh.indices.length / 3).toBe(30);
    expect(area(mesh)).toBeCloseTo(24, 6);
    for (let v = 0; v < mesh.positions.length / 3; v++) {
      expect(mesh.positions[3 * v]).toBeCloseTo((mesh.uvs[2 * v] - 0.5) * 6, 5);
      expect(mesh.positions[3 * v + 2]).toBeCloseTo(-(mesh.uvs[2 * v + 1] - 0.5) * 4, 5);
    }
  });
});

const shoelace = (outline: readonly (readonly [number, number])[]): number =>
  sum(
    outline.map(([x, y], i) => {
      const [x1, y1] = outline[(i + 1) % outline.length];
      return (x * y1 - x1 * y) / 2;
    }),
  );

/** A star-shaped outline around the origin, hence simple; mostly concave. */
const starOutline = fc
  .array(fc.double({ min: 0.2, max: 3, noNaN: true }), { minLength: 3, maxLength: 24 })
  .map((radii) =>
    radii.map((r, i): [number, number] => {
      const angle = (2 * Math.PI * i) / radii.length;
      return [r * Math.cos(angle), r * Math.sin(angle)];
    }),
  );

describe('makeMesh', () => {
  it('triangulates any simple outline: same area and winding, every corner used', () => {
    fc.assert(
      fc.property(starOutline, (outline) => {
        const mesh = polygon(outline);
        expect(mesh.indices.length / 3).toBe(outline.length - 2);
        expect(area(mesh)).toBeCloseTo(shoelace(outline), 4);
        for (const [a, b, c] of triangles(mesh)) expect(cross(sub(b, a), sub(c, a))[2]).toBeGreaterThan(-1e-6);
      }),
      { numRuns: 60 },
    );
  });

  it('keeps corners on straight sides, without degenerate triangles', () => {
    const straight: [number, number][] = [
      [0, 0],
      [1, 0],
      [2, 0],
      [3, 0],
      [2, 1],
      [1, 2],
      [0, 3],
      [0, 2],
      [0, 1],
    ];
    const notch: [number, number][] = [
      [0, 0],
      [2, 0],
      [4, 0],
      [4, 3],
      [3, 3],
      [3, 1],
      [2, 1],
      [1, 1],
      [1, 3],
      [0, 3],
    ];
    for (const outline of [straight, notch]) {
      const mesh = polygon(outline);
      expect(new Set(mesh.indices).size).toBe(outline.length);
      expect(area(mesh)).toBeCloseTo(shoelace(outline), 6);
      for (const [a, b, c] of triangles(mesh)) expect(cross(sub(b, a), sub(c, a))[2]).toBeGreaterThan(0.1);
    }
  });

  it('cuts a concave quad inside, a left-handed one the other way round', () => {
    const dart: [number, number][] = [
      [0, 0],
      [2, -1],
      [0.5, 0],
      [2, 1],
    ];
    const turned: [number, number][] = [
      [2, -1],
      [0.5, 0],
      [2, 1],
      [0, 0],
    ];
    for (const outline of [dart, turned]) expect(area(polygon(outline))).toBeCloseTo(Math.abs(shoelace(outline)), 6);
    const left = polygon(
      [
        [0, 0],
        [0, 1],
        [1, 1],
        [1, 0],
      ],
      { leftHanded: true },
    );
    expect([...left.normals.slice(0, 3)].map((x) => x + 0)).toEqual([0, 0, 1]);
    expect(triangles(left).every(([a, b, c]) => cross(sub(b, a), sub(c, a))[2] > 0)).toBe(true);
  });

  it('splits vertices only where attributes differ', () => {
    const cube = box([1, 1, 1]);
    expect(cube.positions.length / 3).toBe(24);
    const faces = { points: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], faceCounts: [3, 3], faceIndices: [0, 1, 2, 0, 2, 3] };
    expect(makeMesh(faces).mesh.positions.length / 3).toBe(4);
    const uvs = { per: 'face' as const, values: [0, 0, 1, 1] };
    expect(makeMesh({ ...faces, uvs }).mesh.positions.length / 3).toBe(6);
    const colors = { per: 'point' as const, values: [1, 0, 0, 0, 1, 0], indices: [0, 0, 1, 1] };
    const colored = makeMesh({ ...faces, colors, faceMaterials: [3, 1] });
    expect([...colored.mesh.colors!.slice(0, 3)]).toEqual([1, 0, 0]);
    expect(colored.mesh.groups).toEqual([
      { start: 0, count: 3, material: 3 },
      { start: 3, count: 3, material: 1 },
    ]);
    const moved = gatherPoints(
      faces.points.map((x) => 2 * x),
      colored.pointOfVertex,
    );
    expect([...moved]).toEqual([...colored.mesh.positions].map((x) => 2 * x));
  });

  it('skips and counts invalid faces', () => {
    const points = [0, 0, 0, 1, 0, 0, 0, 1, 0];
    const built = makeMesh({ points, faceCounts: [2, 3, 3, 3], faceIndices: [0, 1, 0, 1, 2, 0, 1, 9, 0, 1, -1] });
    expect(built.skippedFaces).toBe(3);
    expect(built.mesh.indices.length).toBe(3);
  });

  it('smooth normals join faces under the angle and not over it', () => {
    const faces = (smoothAngle: number) => {
      const n = 12;
      const ring = Array.from({ length: n }, (_, i) => [
        Math.cos((2 * Math.PI * i) / n),
        Math.sin((2 * Math.PI * i) / n),
      ]);
      const points = [...ring.flatMap(([x, y]) => [x, y, 0]), ...ring.flatMap(([x, y]) => [x, y, 1])];
      const faceIndices = ring.flatMap((_, i) => [i, (i + 1) % n, n + ((i + 1) % n), n + i]);
      return makeMesh({ points, faceCounts: ring.map(() => 4), faceIndices, smoothAngle }).mesh;
    };
    const smooth = faces(Math.PI / 4);
    for (let v = 0; v < smooth.positions.length / 3; v++) {
      const [x, y] = pointAt(smooth.positions, v);
      expect(distance(pointAt(smooth.normals, v), [x, y, 0])).toBeLessThan(1e-6);
    }
    expect(faces(Math.PI / 8).positions.length / 3).toBe(48);
  });
});

describe('deformedNormals', () => {
  it('a sheared sphere’s normals are sheared, without a seam along its uv seam', () => {
    const ball = sphere(1, { segments: 96 });
    const sheared = Float32Array.from(ball.positions, (x, i) => (i % 3 === 0 ? x + 0.5 * ball.positions[i + 1] : x));
    const normals = deformedNormals(sheared, ball.indices, smoothingGroups(ball));
    for (let v = 0; v < sheared.length / 3; v++) {
      const [x, y, z] = pointAt(ball.positions, v);
      if (Math.abs(z) > 0.95) continue;
      // The cofactor matrix of the shear x → x + y/2.
      expect(distance(pointAt(normals, v), normalize([x, y - 0.5 * x, z]))).toBeLessThan(0.04);
    }
  });
});

describe('smoothingGroups', () => {
  it('joins vertices of equal position and normal, whatever their order and the sign of zeros', () => {
    const mesh = box([1, 1, 1]);
    const [p, q] = [
      [0, 1, 2],
      [-0, 1, 2],
    ];
    const up = [0, 0, 1];
    const positions = Float32Array.from([...p, 3, 4, 5, ...q, ...p, ...p]);
    const normals = Float32Array.from([...up, ...up, ...up, 0, 1, 0, ...up]);
    expect([...smoothingGroups({ ...mesh, positions, normals })]).toEqual([0, 1, 0, 3, 0]);
  });
});

describe('smoothingGroups of many vertices', () => {
  it('equal those of a lookup table', () => {
    const numbers = fc.array(fc.constantFrom(0, -0, 1, -1, 0.5, Number.NaN), { minLength: 600, maxLength: 1800 });
    fc.assert(
      fc.property(numbers, numbers, (p, n) => {
        const vertices = Math.floor(Math.min(p.length, n.length) / 3);
        const [positions, normals] = [p, n].map((list) => Float32Array.from(list.slice(0, 3 * vertices)));
        const first = new Map<string, number>();
        const expected = Array.from({ length: vertices }, (_, v) => {
          const key = [...pointAt(positions, v), ...pointAt(normals, v)].join();
          first.set(key, first.get(key) ?? v);
          return first.get(key);
        });
        expect([...smoothingGroups({ ...box([1, 1, 1]), positions, normals })]).toEqual(expected);
      }),
      { numRuns: 20 },
    );
  });
});

describe('transformMesh and mergeMeshes', () => {
  const orientation = fromAxisAngle([1, 2, 3], 1);
  it('transforms area and normals, and flips the winding of mirrored meshes', () => {
    const moved = transformMesh(box([1, 2, 3]), fromParts(toMatrix(orientation), [10, 20, 30]));
    expect(area(moved)).toBeCloseTo(22, 4);
    const mirrored = transformMesh(cylinder(1, 2), [-1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1]);
    expect(volume(mirrored)).toBeCloseTo(6 * volume(cylinder(1, 2)), 4);
    for (const [k, [a, b, c]] of triangles(mirrored).entries()) {
      const n = cross(sub(b, a), sub(c, a));
      expect(dot(n, pointAt(mirrored.normals, mirrored.indices[3 * k]))).toBeGreaterThan(0);
    }
    const tilted = pointAt(transformMesh(plane(1, 1), fromParts(toMatrix(orientation), [0, 0, 0])).normals, 0);
    expect(distance(tilted, rotate(orientation, [0, 0, 1]))).toBeLessThan(1e-6);
  });

  it('keeps groups, and joins adjacent ones of the same material', () => {
    const parts = [
      withMaterial(box([1, 1, 1]), 2),
      withMaterial(sphere(1, { segments: 8 }), 2),
      withMaterial(plane(1, 1), 0),
    ];
    const merged = mergeMeshes(parts);
    expect(merged.groups.map((g) => g.material)).toEqual([2, 0]);
    expect(sum(merged.groups.map((g) => g.count))).toBe(merged.indices.length);
    expect(area(merged)).toBeCloseTo(sum(parts.map(area)), 5);
    expect(merged.colors).toBeUndefined();
  });
});

describe('a point with very many faces', () => {
  // A cone of 100 000 sides: comparing each with each would be 10¹⁰ steps.
  const sides = 100_000;
  const rim = Array.from({ length: sides }, (_, i) => (2 * Math.PI * i) / sides);
  const polygons = {
    points: [0, 0, 1, ...rim.flatMap((a) => [Math.cos(a), Math.sin(a), 0])],
    faceCounts: rim.map(() => 3),
    faceIndices: rim.flatMap((_, i) => [0, 1 + i, 1 + ((i + 1) % sides)]),
  };
  it('is triangulated, with flat and with smooth normals', () => {
    expect(makeMesh(polygons).mesh.indices.length).toBe(3 * sides);
    const { mesh, pointOfVertex } = makeMesh({ ...polygons, smoothAngle: Math.PI / 6 });
    expect(mesh.indices.length).toBe(3 * sides);
    const apex = pointOfVertex.indexOf(0);
    expect(distance(pointAt(mesh.normals, apex), [0, 0, 1])).toBeLessThan(1e-6);
  });
});
