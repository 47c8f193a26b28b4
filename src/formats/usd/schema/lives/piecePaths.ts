import type { SceneObject } from '../../../../scene/types.ts';

/**
 * The names of an object that exists at `lives` separate times, and is `piece` of a thing with several shapes, or all of it: its own path if it is one life of
 * one shape, else `/Thing/piece2`, and of the second life of that piece `/Thing/piece2_2`.
 */
export function piecePaths(
  path: string,
  piece: number | undefined,
  lives: number,
): Pick<SceneObject, 'path' | 'pieceOf'>[] {
  if (piece === undefined && lives === 1) return [{ path }];
  return Array.from({ length: lives }, (_, i) => {
    const name = piece === undefined ? `${i + 1}` : i === 0 ? `${piece}` : `${piece}_${i + 1}`;
    return { path: `${path}/piece${name}`, pieceOf: path };
  });
}
