import type { PrimSpec } from '../../layer/layer.ts';
import { parentOf } from '../../layer/primPaths.ts';
import { targetsOf } from '../../layer/query.ts';

/** Adds the prototype paths of all instancers below the given prims, with their ancestors. */
export function collectPrototypePaths(prims: ReadonlyMap<string, PrimSpec>, to: Set<string>): Set<string> {
  for (const prim of prims.values()) {
    const own = prim.typeName === 'PointInstancer' ? targetsOf(prim, 'prototypes') : [];
    for (const path of own) for (let at = path; at !== '' && !to.has(at); at = parentOf(at)) to.add(at);
    collectPrototypePaths(prim.children, to);
  }
  return to;
}
