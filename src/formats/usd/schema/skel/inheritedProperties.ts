import type { Layer, PrimSpec } from '../../layer/layer.ts';
import { primsAlong, targetsOf } from '../../layer/query.ts';

/** The nearest prim at or above a path for which `found` returns true. */
export const nearestAncestor = (layer: Layer, path: string, found: (prim: PrimSpec) => boolean): PrimSpec | undefined =>
  primsAlong(layer, path).findLast(found);

/** The target of a relationship, inherited from the nearest prim that has it. */
export function nearestTarget(layer: Layer, path: string, name: string): string | undefined {
  const prim = nearestAncestor(layer, path, ({ properties }) => properties.has(name));
  return prim && targetsOf(prim, name)[0];
}
