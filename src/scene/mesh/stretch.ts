import { cofactors, determinant, type Mat3, transform } from '../../math/mat3.ts';
import { fromParts } from '../../math/mat4.ts';
import { normalize, type Vec3, ZERO } from '../../math/vec3.ts';
import type { Mesh, SceneObject } from '../types.ts';
import { transformMesh } from './meshOps.ts';
import { pointAt } from './polygons.ts';

/** A mesh with the stretch of its object. */
export type StretchedMesh = Pick<SceneObject, 'mesh' | 'stretch'>;

/** The points of one. */
export interface StretchedPoints extends Pick<SceneObject, 'stretch'> {
  readonly mesh: Pick<Mesh, 'positions'>;
}

/** Whether a map can be a stretch: finite, and it neither flattens nor mirrors. */
export const isProperStretch = (stretch: Mat3): boolean => {
  const volume = determinant(stretch);
  return stretch.every(Number.isFinite) && Number.isFinite(volume) && volume > 0;
};

/** Vertex i in the object's own frame [m]. */
export function objectPoint({ mesh, stretch }: StretchedPoints, i: number): Vec3 {
  const point = pointAt(mesh.positions, i);
  return stretch ? transform(stretch, point) : point;
}

/** A normal n of the mesh in the object's own frame, of any length: S⁻ᵀ n, up to the factor det S > 0. */
export const stretchedNormal = (n: Vec3, stretch: Mat3 | undefined): Vec3 =>
  stretch ? transform(cofactors(stretch), n) : n;

/** The normal of vertex i in the object's own frame, of unit length. */
export function objectNormal({ mesh, stretch }: StretchedMesh, i: number): Vec3 {
  const normal = pointAt(mesh.normals, i);
  return stretch ? normalize(stretchedNormal(normal, stretch), normal) : normal;
}

/** A mesh of its own, with the stretch applied to its vertices. */
export const bakedMesh = ({ mesh, stretch }: StretchedMesh): Mesh =>
  stretch ? transformMesh(mesh, fromParts(stretch, ZERO)) : mesh;

/** The same object without a stretch: its mesh is baked. */
export function bakedObject<O extends StretchedMesh>(object: O): Omit<O, 'stretch'> {
  const { stretch: _, ...rest } = object;
  return { ...rest, mesh: bakedMesh(object) };
}
