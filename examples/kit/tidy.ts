import { IDENTITY as UNTURNED } from '../../src/math/mat3.ts';
import { fromParts } from '../../src/math/mat4.ts';
import { scale, type Vec3 } from '../../src/math/vec3.ts';
import { transformMesh } from '../../src/scene/mesh/meshOps.ts';
import type { Mesh, Motion } from '../../src/scene/types.ts';

const rounded = (values: Float32Array, digits: number): Float32Array => {
  const k = 10 ** digits;
  return values.map((x) => Math.round(x * k) / k + 0);
};

/** Grid of positions, per metre: 0.1 mm. */
const GRID = 1e4;

/**
 * A mesh around the middle of its base, and where that is [m], so that equal things in several places have equal meshes,
 * which are kept once. Between two places of the grid the lower one is taken, whatever the last digits are.
 */
export function aroundBase(mesh: Mesh): { readonly mesh: Mesh; readonly base: Vec3 } {
  const { positions } = mesh;
  const sides = [0, 1, 2].map((k) => {
    const along = positions.filter((_, i) => i % 3 === k).map((x) => Math.round(x * GRID));
    return [along.reduce((a, b) => Math.min(a, b)), along.reduce((a, b) => Math.max(a, b))];
  });
  const middle = ([low, high]: readonly number[]): number => Math.floor((low + high) / 2 + 0.25) / GRID;
  const base: Vec3 = [middle(sides[0]), sides[1][0] / GRID, middle(sides[2])];
  if (mesh.quadric) return { mesh: transformMesh(mesh, fromParts(UNTURNED, scale(base, -1))), base };
  return { mesh: { ...mesh, positions: positions.map((x, i) => x - base[i % 3]) }, base };
}

/** Samples of poses as f32, which take half the room in a file. Cameras keep theirs: their speed is that of the observer. */
export const roundMotion = <M extends Motion>(motion: M): M =>
  motion.kind === 'sampled' ? { ...motion, poses: motion.poses.map(Math.fround) } : motion;

/** Rounds positions to 0.1 mm and normals to 0.001, so that files are short and equal things equal. Round solids, written by their radius, stay as they are. */
export const roundMesh = (mesh: Mesh): Mesh =>
  mesh.quadric
    ? mesh
    : {
        ...mesh,
        positions: rounded(mesh.positions, Math.log10(GRID)),
        normals: rounded(mesh.normals, 3),
        uvs: rounded(mesh.uvs, 4),
      };
