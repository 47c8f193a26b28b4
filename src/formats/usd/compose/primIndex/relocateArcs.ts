import { msg } from '../../../../messages/message.ts';
import { IDENTITY, mapToTarget } from './namespaceMap.ts';
import type { PrimIndexBuilder } from './primIndexBuilder.ts';
import { makeInert, type PrimIndexNode } from './primIndexNode.ts';

/** Adds the source of a relocate whose target is this node: only opinions from its arcs count. */
export function addRelocateArc(builder: PrimIndexBuilder, node: PrimIndexNode): void {
  const source = node.stack.relocates?.byTarget.get(node.path);
  if (source === undefined || (node.isInert && node.depthBelowArc === 0)) return;
  for (const child of node.children) if (child.arc.kind !== 'variant') makeInert(child);
  const arc = { kind: 'relocate' as const, map: IDENTITY, number: 0, depth: node.depth };
  const added = builder.addArc(node, node.stack, source, arc, { contributes: false, ancestral: true });
  if (!added) return;
  if (added.opinions.length > 0) {
    const message = msg`${source} is moved to ${node.path} by a relocate, and opinions on it in ${node.stack.root.id} do not count; write them at ${node.path}`;
    builder.report('usd.relocates', message);
  }
  makeRelocatedInert(added);
}

/** Makes nodes inert that other relocates move elsewhere. */
function makeRelocatedInert(tree: PrimIndexNode): void {
  for (const child of tree.children) {
    if (child.arc.kind === 'relocate') continue;
    if (!child.isInert && child.stack.relocates?.bySource.has(child.path)) makeInert(child);
    else makeRelocatedInert(child);
  }
}

/** A relocate in a referenced layer also applies where it is referenced. */
export function implyRelocateArc(builder: PrimIndexBuilder, node: PrimIndexNode): void {
  const above = node.parent?.parent;
  if (node.isAncestral || !node.parent || !above) return;
  const source = mapToTarget(node.parent.arc.map, node.path);
  if (source === undefined) return;
  if (above.children.some((child) => child.arc.kind === 'relocate' && child.path === source)) return;
  const arc = { kind: 'relocate' as const, origin: node, map: IDENTITY, number: 0, depth: above.depth };
  builder.addArc(above, above.stack, source, arc, { contributes: false });
}
