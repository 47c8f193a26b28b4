import type { Lifetime } from '../../../scene/types.ts';

/** What is written as one prim: an object or a light, or all pieces of one in the order of their times. */
export interface WrittenThing<T> {
  readonly path: string;
  readonly pieces: readonly [T, ...T[]];
}

interface LivingPart {
  readonly path: string;
  readonly pieceOf?: string;
  readonly lifetime: Lifetime;
}

/** Gathers the pieces of each thing; where they cannot be one prim, each is a thing of its own. */
export function thingsOf<T extends LivingPart>(
  items: readonly T[],
  areOne: (pieces: readonly [T, ...T[]], path: string) => boolean,
): WrittenThing<T>[] {
  const byPath = new Map<string, [T, ...T[]]>();
  for (const item of items) {
    const path = item.pieceOf ?? item.path;
    const pieces = byPath.get(path);
    if (pieces) pieces.push(item);
    else byPath.set(path, [item]);
  }
  return [...byPath].flatMap(([path, pieces]): WrittenThing<T>[] => {
    if (pieces.length === 1) return [{ path: pieces[0].path, pieces }];
    pieces.sort((a, b) => a.lifetime.birth - b.lifetime.birth);
    const takeTurns = pieces.every(({ lifetime }, i) => i === 0 || lifetime.birth >= pieces[i - 1].lifetime.death);
    if (takeTurns && areOne(pieces, path)) return [{ path, pieces }];
    return pieces.map((piece) => ({ path: piece.path, pieces: [piece] }));
  });
}
