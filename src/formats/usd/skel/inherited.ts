import { primAt, targetsOf } from '../context.ts';
import type { Layer, PrimSpec } from '../layer.ts';

/** The nearest prim, at a path or above it, for which `found` holds. */
export function nearest(layer: Layer, path: string, found: (prim: PrimSpec) => boolean): PrimSpec | undefined {
  for (let at = path; at !== ''; at = at.slice(0, at.lastIndexOf('/'))) {
    const prim = primAt(layer, at);
    if (prim && found(prim)) return prim;
  }
  return undefined;
}

/** The target of a relationship, as the nearest prim has it that says so. */
export function nearestTarget(layer: Layer, path: string, name: string): string | undefined {
  const prim = nearest(layer, path, ({ properties }) => properties.has(name));
  return prim && targetsOf(prim, name)[0];
}
