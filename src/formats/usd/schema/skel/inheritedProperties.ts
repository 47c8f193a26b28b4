import type { Layer, PrimSpec } from '../../layer/layer.ts';
import { primsAlong, targetsOf } from '../../layer/query.ts';

/** The nearest prim, at a path or above it, for which `found` holds. */
export const nearestAncestor = (layer: Layer, path: string, found: (prim: PrimSpec) => boolean): PrimSpec | undefined =>
  primsAlong(layer, path).findLast(found);

/** The target of a relationship, as the nearest prim has it that says so. */
export function nearestTarget(layer: Layer, path: string, name: string): string | undefined {
  const prim = nearestAncestor(layer, path, ({ properties }) => properties.has(name));
  return prim && targetsOf(prim, name)[0];
}
