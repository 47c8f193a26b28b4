import type { Mat4 } from '../../math/mat4.ts';

/** A round solid about the Z axis, centred on the origin, as UsdGeom defines them; lengths in its own units. */
export type QuadricShape =
  | { readonly kind: 'sphere'; readonly radius: number }
  | { readonly kind: 'cylinder'; readonly radius: number; readonly height: number }
  /** Its apex is at +height/2. */
  | { readonly kind: 'cone'; readonly radius: number; readonly height: number }
  /** `height` is that of the cylinder between the two hemispheres. */
  | { readonly kind: 'capsule'; readonly radius: number; readonly height: number };

/** The round solid that a mesh approximates by polygons. */
export interface Quadric {
  /** In its own axes. */
  readonly shape: QuadricShape;
  /** From the solid's own axes to the mesh's [m]; it may scale and shear. */
  readonly toMesh: Mat4;
  /** Faces of the mesh around the axis. */
  readonly segments: number;
  /** Bands of faces between the poles of a sphere, or of each hemisphere of a capsule; otherwise 1. */
  readonly rings: number;
}
