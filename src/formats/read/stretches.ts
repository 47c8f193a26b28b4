import { invert, type Mat3, multiply } from '../../math/mat3.ts';
import { meshBoundingSphere } from '../../scene/bounds/bounds.ts';
import { bakedMesh, isProperStretch, type StretchedMesh } from '../../scene/mesh/stretch.ts';
import type { Mesh, SceneObject } from '../../scene/types.ts';

/** Meshes of fewer vertices are copied for each stretch: that costs no more than to remember it. */
const LEAST_SHARED_VERTICES = 64;

/** The largest number in f32. */
const MOST = 3.4e38;

/** Resolution of the keys relative to the largest element: products of f64 matrices differ by less. */
const RESOLUTION = 1e-9;

const MIRROR: Mat3 = [-1, 0, 0, 0, 1, 0, 0, 0, 1];

/** A mesh under a constant linear map, which may mirror or flatten it. Only where bodies can share it does it stay a map, with a positive determinant. */
export function stretchedMesh(mesh: Mesh, linear: Mat3): StretchedMesh {
  if (linear.every((x, i) => Math.abs(x - (i % 4 === 0 ? 1 : 0)) < 1e-12)) return { mesh };
  if (!isShareable(mesh)) return { mesh: bakedOnce(mesh, linear) };
  if (isBounded(mesh, linear)) return { mesh, stretch: linear };
  const mirrored = multiply(linear, MIRROR);
  if (isBounded(mesh, mirrored)) return { mesh: bakedOnce(mesh, MIRROR), stretch: mirrored };
  return { mesh: bakedOnce(mesh, linear) };
}

const isShareable = ({ positions, quadric }: Mesh): boolean =>
  !quadric && positions.length >= 3 * LEAST_SHARED_VERTICES;

/** Whether it is a proper stretch, and no vertex overflows. */
function isBounded(mesh: Mesh, stretch: Mat3): boolean {
  if (!isProperStretch(stretch) || !invert(stretch)) return false;
  const { center, radius } = meshBoundingSphere(mesh);
  return Math.hypot(...stretch) * (Math.hypot(...center) + radius) < MOST;
}

/** Arrays of baked meshes by positions, indices and stretch, so that meshes with other materials share them. */
type BakedArrays = Pick<Mesh, 'positions' | 'normals' | 'indices' | 'quadric'>;
const BAKED = new WeakMap<Float32Array, WeakMap<Uint32Array, Map<string, BakedArrays>>>();
const MESHES = new WeakMap<Mesh, WeakMap<BakedArrays, Mesh>>();

/** The mesh with a map applied to its vertices, the same one for equal maps. */
function bakedOnce(mesh: Mesh, linear: Mat3): Mesh {
  const ofPositions = BAKED.get(mesh.positions) ?? new WeakMap<Uint32Array, Map<string, BakedArrays>>();
  BAKED.set(mesh.positions, ofPositions);
  const byStretch = ofPositions.get(mesh.indices) ?? new Map<string, BakedArrays>();
  ofPositions.set(mesh.indices, byStretch);
  const key = stretchKey(linear);
  const arrays = byStretch.get(key) ?? bakedMesh({ mesh, stretch: linear });
  byStretch.set(key, arrays);
  const meshes = MESHES.get(mesh) ?? new WeakMap<BakedArrays, Mesh>();
  MESHES.set(mesh, meshes);
  const { positions, normals, indices, quadric } = arrays;
  const { quadric: _, ...rest } = mesh;
  const made = meshes.get(arrays) ?? { ...rest, positions, normals, indices, ...(quadric && { quadric }) };
  meshes.set(arrays, made);
  return made;
}

function stretchKey(stretch: Mat3): string {
  const size = Math.max(...stretch.map(Math.abs));
  return [size.toPrecision(9), ...stretch.map((x) => Math.round(x / (RESOLUTION * size)))].join(' ');
}

/** Bakes meshes that all objects which have them stretch alike: a mesh of its own size is what most files mean. */
export function settleStretches(objects: readonly SceneObject[]): readonly SceneObject[] {
  const stretches = new Map<Float32Array, string | undefined>();
  for (const { mesh, stretch } of objects) {
    const key = stretch ? stretchKey(stretch) : '';
    const known = stretches.has(mesh.positions) ? stretches.get(mesh.positions) : key;
    stretches.set(mesh.positions, known === key ? key : undefined);
  }
  return objects.map((object) => {
    const { stretch, ...rest } = object;
    if (!stretch || stretches.get(object.mesh.positions) === undefined) return object;
    return { ...rest, mesh: bakedOnce(object.mesh, stretch) };
  });
}
