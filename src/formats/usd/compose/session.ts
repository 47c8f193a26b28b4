import type { Layer, PrimSpec } from '../layer.ts';
import { isPrimPath } from './paths.ts';

/** A variant that the user chose instead of the file's; an empty one takes the choice away. */
export interface VariantChoice {
  /** Of the prim that has the set. */
  readonly path: string;
  readonly set: string;
  readonly variant: string;
}

/** The choices as a layer of overs, above all others. */
export function sessionLayer(choices: readonly VariantChoice[]): Layer {
  const layer: Layer = { name: '', metadata: new Map(), rootPrims: new Map() };
  for (const { path, set, variant } of choices) {
    if (!isPrimPath(path)) continue;
    const prim = overAt(layer, path);
    const written = prim.metadata.get('variants');
    const selections = new Map(written?.type === 'texts-by-name' ? written.data : []);
    prim.metadata.set('variants', { type: 'texts-by-name', data: selections.set(set, variant) });
  }
  return layer;
}

function overAt(layer: Layer, path: string): PrimSpec {
  let children = layer.rootPrims;
  let prim: PrimSpec | undefined;
  for (const name of path.split('/').slice(1)) {
    prim = children.get(name) ?? emptyOver(`${prim?.path ?? ''}/${name}`, name);
    children.set(name, prim);
    children = prim.children;
  }
  return prim!;
}

const emptyOver = (path: string, name: string): PrimSpec => ({
  path,
  name,
  specifier: 'over',
  typeName: '',
  metadata: new Map(),
  properties: new Map(),
  children: new Map(),
  variantSets: new Map(),
});
