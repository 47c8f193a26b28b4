import { isVariantName, selectionOf } from '../../layer/primPaths.ts';
import { expandOrKeep } from '../layers/expressions.ts';
import { variantSetsAt } from '../layers/siteOpinions.ts';
import { hasMetadata, type PrimIndexNode, strongestFirst } from '../primIndex/primIndexNode.ts';

/** A variant set of a composed prim. */
export interface ComposedVariantSet {
  readonly path: string;
  readonly set: string;
  readonly variants: readonly string[];
  /** As selected by layers or user; need not be a valid variant. */
  readonly selected?: string;
}

/** Variant sets of a prim, strongest site first, with the variants of all sites. */
export function variantSetsOf(index: PrimIndexNode, path: string): ComposedVariantSet[] {
  if (!hasMetadata(index, 'variantSets')) return [];
  const nodes = strongestFirst(index).filter((node) => node.contributes);
  const [variants, selections] = [variantsIn(nodes), selectionsIn(nodes)];
  const sets = new Set(nodes.flatMap(({ opinions }) => variantSetsAt(opinions)));
  return [...sets].map((set) => {
    const selected = selections.get(set);
    const names = [...(variants.get(set) ?? [])].filter(isVariantName).sort();
    return { path, set, variants: names, ...(selected ? { selected } : {}) };
  });
}

/** The names of all variants that any site has, by set. */
function variantsIn(nodes: readonly PrimIndexNode[]): ReadonlyMap<string, ReadonlySet<string>> {
  const found = new Map<string, Set<string>>();
  for (const { opinions } of nodes)
    for (const { spec } of opinions)
      for (const [set, variants] of spec.variantSets) {
        const names = found.get(set) ?? new Set();
        found.set(set, names);
        for (const name of variants.keys()) names.add(name);
      }
  return found;
}

/** By set, the variant that the prim has, else the one that is asked for first. */
function selectionsIn(nodes: readonly PrimIndexNode[]): ReadonlyMap<string, string> {
  const found = new Map<string, string>();
  for (const node of nodes) {
    const [set, variant] = (node.isDirect && node.arc.kind === 'variant' && selectionOf(node.path)) || [];
    if (set !== undefined && variant !== undefined && !found.has(set)) found.set(set, variant);
  }
  for (const { opinions } of nodes)
    for (const { spec, from } of opinions) {
      const written = spec.metadata.get('variants');
      if (written?.type !== 'texts-by-name') continue;
      for (const [set, text] of written.data) if (!found.has(set)) found.set(set, expandOrKeep(text, from.variables));
    }
  return found;
}
