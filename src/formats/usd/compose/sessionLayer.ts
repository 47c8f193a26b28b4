import { EMPTY_MAP, type Layer, type PrimSpec, withEntry } from '../layer/layer.ts';
import { isPrimPath } from '../layer/primPaths.ts';

/** A variant that the user chose instead of the file's; an empty one takes the choice away. */
export interface VariantSelection {
  /** Of the prim that has the set. */
  readonly path: string;
  readonly set: string;
  readonly variant: string;
}

/** The choices as a layer of overs, above all others. */
export function sessionLayer(choices: readonly VariantSelection[]): Layer {
  const root = emptyOver('', '');
  for (const { path, set, variant } of choices) {
    if (!isPrimPath(path)) continue;
    const prim = overAt(root, path);
    const written = prim.metadata.get('variants');
    const selections = new Map(written?.type === 'texts-by-name' ? written.data : []);
    prim.metadata = new Map([['variants', { type: 'texts-by-name', data: selections.set(set, variant) }]]);
  }
  return { name: '', metadata: EMPTY_MAP, rootPrims: root.children };
}

function overAt(root: PrimSpec, path: string): PrimSpec {
  let prim = root;
  for (const name of path.split('/').slice(1)) {
    const child: PrimSpec = prim.children.get(name) ?? emptyOver(`${prim.path}/${name}`, name);
    prim.children = withEntry(prim.children, name, child);
    prim = child;
  }
  return prim;
}

const emptyOver = (path: string, name: string): PrimSpec => ({
  path,
  name,
  specifier: 'over',
  typeName: '',
  metadata: EMPTY_MAP,
  properties: EMPTY_MAP,
  children: EMPTY_MAP,
  variantSets: EMPTY_MAP,
});
