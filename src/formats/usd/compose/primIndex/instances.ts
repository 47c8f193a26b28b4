import { type PrimIndexNode, strongestFirst } from './primIndexNode.ts';

/** Whether a prim is an instance: `instanceable`, with an arc to share. Only opinions on the prim itself are then local. */
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
