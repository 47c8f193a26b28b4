import type { PrimSpec } from '../../layer/layer.ts';
import { targetsOf } from '../../layer/query.ts';

/** The relationship of a mesh, or of prims above it, to its skeleton. */
export const SKELETON = 'skel:skeleton';

/** Whether meshes at or below a prim may be skinned; `around`: of its parent. */
export const maybeSkinned = (prim: PrimSpec, around: boolean): boolean =>
  prim.properties.has(SKELETON) ? targetsOf(prim, SKELETON).length > 0 : around;
