import { type Layer, NOTHING, type PrimSpec, withEntry } from '../layer.ts';
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
  const root = emptyOver('', '');
  for (const { path, set, variant } of choices) {
    if (!isPrimPath(path)) continue;
    const prim = overAt(root, path);
    const written = prim.metadata.get('variants');
    const selections = new Map(written?.type === 'texts-by-name' ? written.data : []);
    prim.metadata = new Map([['variants', { type: 'texts-by-name', data: selections.set(set, variant) }]]);
  }
  return { name: '', metadata: NOTHING, rootPrims: root.children };
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
  metadata: NOTHING,
  properties: NOTHING,
  children: NOTHING,
  variantSets: NOTHING,
});
