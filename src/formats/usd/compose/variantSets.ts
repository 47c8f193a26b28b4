import { isSaid, type Node, strongestFirst } from './node.ts';
import { selectionOf } from './paths.ts';
import { selectionAt, variantSetsAt, variantsAt } from './sites.ts';

/** What a prim lets one choose between. */
export interface OfferedSet {
  readonly path: string;
  readonly set: string;
  readonly variants: readonly string[];
  /** As the layers or the user select; it need not be among the variants. */
  readonly selected?: string;
}

/** The sets of a prim, those of the strongest site first, with all variants that any site has. */
export function variantSetsOf(index: Node, path: string): OfferedSet[] {
  if (!isSaid(index, 'variantSets')) return [];
  const nodes = strongestFirst(index).filter((node) => node.contributes);
  const variants = new Map<string, Set<string>>();
  for (const node of nodes)
    for (const set of variantSetsAt(node.opinions)) {
      const names = variants.get(set) ?? new Set();
      variants.set(set, names);
      for (const other of nodes) for (const name of variantsAt(other.opinions, set)) names.add(name);
    }
  return [...variants].map(([name, names]) => {
    const selected = selectedIn(nodes, name);
    return { path, set: name, variants: [...names].sort(), ...(selected ? { selected } : {}) };
  });
}

function selectedIn(nodes: readonly Node[], set: string): string | undefined {
  for (const node of nodes) {
    const [name, variant] = (node.isDirect && node.arc.kind === 'variant' && selectionOf(node.path)) || [];
    if (name === set) return variant;
  }
  for (const node of nodes) {
    const written = selectionAt(node.opinions, set);
    if (written !== undefined) return written;
  }
  return undefined;
}
