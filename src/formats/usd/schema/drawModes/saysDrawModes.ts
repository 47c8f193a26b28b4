import type { Layer, PrimSpec } from '../../layer/layer.ts';

/** Whether a prim says what models are drawn as: only then drawModes.ts is loaded, without which the first picture is there sooner. */
export const saysDrawModes = ({ rootPrims }: Layer): boolean => anySays(rootPrims);

function anySays(prims: PrimSpec['children']): boolean {
  for (const { properties, children } of prims.values())
    if (properties.has('model:drawMode') || anySays(children)) return true;
  return false;
}
