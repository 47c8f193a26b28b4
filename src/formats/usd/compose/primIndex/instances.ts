import { type PrimIndexNode, strongestFirst } from './primIndexNode.ts';

/**
 * Whether a prim shares what is in it with others of the same arcs: it says `instanceable`, and has an arc that leads
 * to something to share. Only what is said on the prim itself is then its own.
 */
export function isInstance(index: PrimIndexNode): boolean {
  index.isInstanceCached ??= isInstanceable(index);
  return index.isInstanceCached;
}

function isInstanceable(index: PrimIndexNode): boolean {
  if (!hasDirectArc(index, false)) return false;
  for (const node of strongestFirst(index)) {
    if (!node.contributes) continue;
    for (const { spec } of node.opinions) {
      const value = spec.metadata.get('instanceable');
      if (value?.type === 'bool') return value.data;
    }
  }
  return false;
}

function hasDirectArc(node: PrimIndexNode, shared: boolean): boolean {
  const own = shared || node.isDirect;
  return (own && node.contributes) || node.children.some((child) => hasDirectArc(child, own));
}
