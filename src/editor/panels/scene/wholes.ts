import type { SceneObject } from '../../../scene/types.ts';

/** Paths of things; one that consists of pieces, which take turns, is one. */
export const wholes = (objects: readonly SceneObject[]): ReadonlySet<string> =>
  new Set(objects.map(({ path, pieceOf }) => pieceOf ?? path));
