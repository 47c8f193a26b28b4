import { fromParts } from '../../src/math/mat4.ts';
import { cross, normalize, scale, sub, type Vec3 } from '../../src/math/vec3.ts';
import { makeMesh } from '../../src/scene/mesh/makeMesh.ts';
import { transformMesh } from '../../src/scene/mesh/meshOps.ts';
import { box, revolve, type SurfaceBand } from '../../src/scene/mesh/primitives.ts';
import { withoutQuadric } from '../../src/scene/mesh/quadric.ts';
import type { Mesh } from '../../src/scene/types.ts';

/** A cone-shaped or level band of a solid of revolution, from and to (radius, height), with one normal. */
export const flatBand = (from: [number, number], to: [number, number], normal: [number, number]): SurfaceBand => ({
  from,
  to,
  fromNormal: normal,
  toNormal: normal,
  v: [0, 1],
});

/** A flat quadrilateral, corners counterclockwise seen from the front; uv from 0 at the first corner to su, sv. */
export function quad(a: Vec3, b: Vec3, c: Vec3, d: Vec3, su = 1, sv = 1): Mesh {
  const uvs = { per: 'corner' as const, values: [0, 0, su, 0, su, sv, 0, sv] };
  return makeMesh({ points: [...a, ...b, ...c, ...d], faceCounts: [4], faceIndices: [0, 1, 2, 3], uvs }).mesh;
}

/** A flat polygon, corners counterclockwise seen from the front; uv in metres along and across its first edge. */
export function polygon(corners: readonly Vec3[], perMetre = 1): Mesh {
  const u = normalize(sub(corners[1], corners[0]));
  const n = normalize(cross(u, sub(corners[2], corners[0])));
  const v = cross(n, u);
  const along = (axis: Vec3, p: Vec3) =>
    (axis[0] * (p[0] - corners[0][0]) + axis[1] * (p[1] - corners[0][1]) + axis[2] * (p[2] - corners[0][2])) * perMetre;
  const uvs = { per: 'corner' as const, values: corners.flatMap((p) => [along(u, p), along(v, p)]) };
  return makeMesh({ points: corners.flat(), faceCounts: [corners.length], faceIndices: corners.map((_, i) => i), uvs })
    .mesh;
}

/** A box that stands on y = 0, centred at the origin; uv in metres times `perMetre`. */
export function block(width: number, height: number, depth: number, perMetre = 1, base: Vec3 = [0, 0, 0]): Mesh {
  const [x, z] = [width / 2, depth / 2];
  const at = (px: number, py: number, pz: number): Vec3 => [base[0] + px, base[1] + py, base[2] + pz];
  const faces = [
    [at(-x, 0, z), at(x, 0, z), at(x, height, z), at(-x, height, z)],
    [at(x, 0, -z), at(-x, 0, -z), at(-x, height, -z), at(x, height, -z)],
    [at(x, 0, z), at(x, 0, -z), at(x, height, -z), at(x, height, z)],
    [at(-x, 0, -z), at(-x, 0, z), at(-x, height, z), at(-x, height, -z)],
    [at(-x, height, z), at(x, height, z), at(x, height, -z), at(-x, height, -z)],
    [at(-x, 0, -z), at(x, 0, -z), at(x, 0, z), at(-x, 0, z)],
  ];
  return join(faces.map((corners) => polygon(corners, perMetre)));
}

/** Merges meshes of one material. */
export function join(parts: readonly Mesh[]): Mesh {
  const points: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const faceIndices: number[] = [];
  for (const part of parts) {
    const first = points.length / 3;
    points.push(...part.positions);
    normals.push(...part.normals);
    uvs.push(...part.uvs);
    for (const i of part.indices) faceIndices.push(first + i);
  }
  return makeMesh({
    points,
    faceCounts: new Array<number>(faceIndices.length / 3).fill(3),
    faceIndices,
    normals: { per: 'point', values: normals },
    uvs: { per: 'point', values: uvs },
  }).mesh;
}

/** A box with rounded edges of radius `r`, centred at the origin; uv 0 … 1 per face. */
export function roundedBox(size: Vec3, r: number, steps = 3): Mesh {
  const faces: Mesh[] = [];
  for (let axis = 0; axis < 3; axis++) for (const side of [-1, 1]) faces.push(roundedFace(size, r, steps, axis, side));
  return join(faces);
}

function roundedFace(size: Vec3, r: number, steps: number, axis: number, side: number): Mesh {
  const [a, b] = side > 0 ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
  // The Minkowski sum of a smaller box and a sphere of radius r; grid lines are at equal angles in the edges.
  const lines = (k: number) => {
    const inner = size[k] / 2 - r;
    const bend = Array.from({ length: steps + 1 }, (_, i) => Math.tan((Math.PI / 4) * (i / steps)) * r);
    return [...bend.map((x) => -inner - x).reverse(), ...bend.map((x) => inner + x)];
  };
  const [la, lb] = [lines(a), lines(b)];
  const points: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  for (const y of lb)
    for (const x of la) {
      const onCube = [0, 0, 0];
      [onCube[axis], onCube[a], onCube[b]] = [(side * size[axis]) / 2, x, y];
      const inner = onCube.map((v, k) => Math.max(-size[k] / 2 + r, Math.min(size[k] / 2 - r, v)));
      const n = normalize(sub([onCube[0], onCube[1], onCube[2]], [inner[0], inner[1], inner[2]]));
      points.push(...inner.map((v, k) => v + r * n[k]));
      normals.push(...n);
      uvs.push(x / size[a] + 0.5, y / size[b] + 0.5);
    }
  const faceIndices: number[] = [];
  for (let j = 0; j + 1 < lb.length; j++)
    for (let i = 0; i + 1 < la.length; i++) {
      const p = j * la.length + i;
      faceIndices.push(p, p + 1, p + la.length + 1, p + la.length);
    }
  const faceCounts = new Array<number>(faceIndices.length / 4).fill(4);
  return makeMesh({
    points,
    faceCounts,
    faceIndices,
    normals: { per: 'point', values: normals },
    uvs: { per: 'point', values: uvs },
  }).mesh;
}

/** A solid of revolution from its outline, radius and height from the bottom up; its corners are sharp except the segments in `smooth`. */
export function turned(outline: readonly (readonly [number, number])[], segments = 24): Mesh {
  const total = outline[outline.length - 1][1] - outline[0][1];
  const bands = outline.slice(1).map((to, i): SurfaceBand => {
    const from = outline[i];
    const l = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const normal: [number, number] = [(to[1] - from[1]) / l, (from[0] - to[0]) / l];
    const v = (h: number) => (h - outline[0][1]) / total;
    return { from, to, fromNormal: normal, toNormal: normal, v: [v(from[1]), v(to[1])] };
  });
  return revolve(bands, segments, 'Y');
}

/** A Tuscan column: plinth, torus, shaft with entasis, echinus and abacus. `radius`: of the shaft at its foot. */
export function column(height: number, radius: number): Mesh {
  const r = radius;
  const roll = (from: number, to: number, middle: number, bulge: number): [number, number][] =>
    Array.from({ length: 7 }, (_, i) => {
      const a = -Math.PI / 2 + (Math.PI * i) / 6;
      return [middle + bulge * Math.cos(a), (from + to) / 2 + ((to - from) / 2) * Math.sin(a)];
    });
  const foot = 0.55 * r;
  const top = height - 0.9 * r;
  const shaft: [number, number][] = Array.from({ length: 9 }, (_, i) => {
    const s = i / 8;
    return [r * (1 - 0.16 * s ** 1.8), foot + 0.42 * r + (top - foot - 0.42 * r) * s];
  });
  const outline: [number, number][] = [
    ...roll(foot, foot + 0.42 * r, 1.02 * r, 0.2 * r),
    ...shaft,
    [0.94 * r, top + 0.04 * r],
    [0.94 * r, top + 0.14 * r],
    [0.86 * r, top + 0.2 * r],
    [0.88 * r, top + 0.3 * r],
    [1.06 * r, top + 0.44 * r],
    [1.14 * r, top + 0.58 * r],
  ];
  const plinth = block(2.5 * r, foot, 2.5 * r);
  const abacus = block(2.5 * r, 0.32 * r, 2.5 * r, 1, [0, top + 0.58 * r, 0]);
  return join([plinth, turned(outline), abacus]);
}

/** A bar of square cross-section between two points [m]. */
export function bar(from: Vec3, to: Vec3, thickness: number): Mesh {
  const along = sub(to, from);
  const z = normalize(along);
  const side = normalize(cross(Math.abs(z[1]) > 0.9 ? [1, 0, 0] : [0, 1, 0], z));
  const up = cross(z, side);
  const middle: Vec3 = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2];
  const m = fromParts([side[0], up[0], z[0], side[1], up[1], z[1], side[2], up[2], z[2]], middle);
  return transformMesh(box([thickness, thickness, Math.hypot(...along)]), m);
}

/** A disc in the plane y = 0, facing up; uv 0 … 1 over its bounding square. */
export function disc(radius: number, segments: number): Mesh {
  const round = Array.from({ length: segments }, (_, i): Vec3 => {
    const a = (-2 * Math.PI * i) / segments;
    return [radius * Math.cos(a), 0, radius * Math.sin(a)];
  });
  const uvs = round.flatMap(([x, , z]) => [x / radius / 2 + 0.5, 0.5 - z / radius / 2]);
  const faceIndices = round.map((_, i) => i);
  return makeMesh({ points: round.flat(), faceCounts: [segments], faceIndices, uvs: { per: 'point', values: uvs } })
    .mesh;
}

export const moved = (mesh: Mesh, by: Vec3): Mesh => transformMesh(mesh, fromParts([1, 0, 0, 0, 1, 0, 0, 0, 1], by));
export const sized = (mesh: Mesh, k: Vec3): Mesh =>
  transformMesh(mesh, fromParts([k[0], 0, 0, 0, k[1], 0, 0, 0, k[2]], scale(k, 0)));

/** A closed mesh with its faces turned inwards. */
export const insideOut = (mesh: Mesh): Mesh => ({
  ...withoutQuadric(mesh),
  normals: mesh.normals.map((x) => -x),
  indices: mesh.indices.map((_, i, all) => all[i % 3 === 0 ? i : i % 3 === 1 ? i + 1 : i - 1]),
});
