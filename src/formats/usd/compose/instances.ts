import { type Node, strongestFirst } from './node.ts';

/**
 * Whether a prim shares what is in it with others of the same arcs: it says `instanceable`, and has an arc that leads
 * to something to share. Only what is said on the prim itself is then its own.
 */
export function isInstance(index: Node): boolean {
  index.isShared ??= saysInstance(index);
  return index.isShared;
}

function saysInstance(index: Node): boolean {
  if (!hasSharedNode(index, false)) return false;
  for (const node of strongestFirst(index)) {
    if (!node.contributes) continue;
    for (const { spec } of node.opinions) {
      const value = spec.metadata.get('instanceable');
      if (value?.type === 'bool') return value.data;
    }
  }
  return false;
}

function hasSharedNode(node: Node, shared: boolean): boolean {
  const own = shared || node.isDirect;
  return (own && node.contributes) || node.children.some((child) => hasSharedNode(child, own));
}
