import { isVariantName, selectionOf, stripVariants, variantPath } from '../../layer/primPaths.ts';
import { opinionsAt } from '../layers/layerStack.ts';
import { selectionAt, variantSetsAt, variantsAt } from '../layers/siteOpinions.ts';
import { IDENTITY, mapToSource, mapToTarget } from './namespaceMap.ts';
import type { PrimIndexBuilder } from './primIndexBuilder.ts';
import { allNodes, type PrimIndexNode, strengthOrder } from './primIndexNode.ts';
import type { IndexTask } from './tasks.ts';

export function addVariantSets(builder: PrimIndexBuilder, node: PrimIndexNode): void {
  for (const [number, set] of variantSetsAt(node.opinions).entries())
    builder.tasks.add({ kind: 'variant', node, set, number });
}

/** Adds the selected variant; else the fallback, once nothing else is left that could select one. */
export function addVariantArc(builder: PrimIndexBuilder, task: IndexTask): void {
  const { node, set = '', number = 0 } = task;
  const fallback = builder.context.fallbacks.get(set)?.find((name) => variantsAt(node.opinions, set).includes(name));
  const selected = task.kind === 'variant' ? selectionFor(builder, node, set) : fallback;
  if (!selected) {
    if (task.kind === 'variant' && fallback) builder.tasks.add({ ...task, kind: 'fallbackVariant' });
    else builder.tasks.postpone(task);
    return;
  }
  if (!isVariantName(selected)) return;
  const arc = { kind: 'variant' as const, map: IDENTITY, number, depth: node.depth };
  if (builder.addArc(node, node.stack, variantPath(node.path, set, selected), arc)) builder.tasks.retryVariants();
}

/** The strongest selection of a set at a node, among all nodes so far, including weaker ones and outer indexes. */
function selectionFor(builder: PrimIndexBuilder, node: PrimIndexNode, set: string): string | undefined {
  const levels = indexLevels(builder, node);
  for (const { root } of levels) builder.work.spend(10 * allNodes(root).length);
  for (const { root, path } of levels) {
    const taken = existingSelection(root, path, builder.ancestorDepth, set);
    if (taken !== undefined) return taken;
  }
  return strongestSelection(levels.reverse(), set);
}

/** An index under construction, and the path in its root's namespace. */
interface IndexLevel {
  readonly root: PrimIndexNode;
  readonly path: string;
  /** The node of this index that the inner index will be attached to. */
  readonly inner?: PrimIndexNode;
}

/** From this index outwards, as far as the path can be mapped. */
function indexLevels(builder: PrimIndexBuilder, node: PrimIndexNode): IndexLevel[] {
  const own = mapToTarget(node.mapToRoot, stripVariants(node.path));
  if (own === undefined) return [{ root: node, path: stripVariants(node.path) }];
  const levels: IndexLevel[] = [{ root: node.root, path: own }];
  let path = own;
  for (let frame = builder.frame; frame; frame = frame.outer.frame) {
    const inParent = mapToTarget(frame.arc.map, path);
    const inRoot = inParent === undefined ? undefined : mapToTarget(frame.parent.mapToRoot, inParent);
    if (inRoot === undefined) break;
    levels.push({ root: frame.parent.root, path: inRoot, inner: frame.parent });
    path = inRoot;
  }
  return levels;
}

/** The variant of the set that was already added for the prim. */
function existingSelection(root: PrimIndexNode, path: string, depth: number, set: string): string | undefined {
  for (const node of allNodes(root)) {
    if (node.arc.kind !== 'variant' || node.depthBelowArc !== depth) continue;
    const [name, variant] = selectionOf(node.pathAtArc) ?? [];
    if (name === set && mapToSource(node.mapToRoot, path) === stripVariants(node.pathAtArc)) return variant;
  }
  return undefined;
}

/** From the outermost index inwards; an inner index comes right after the node it will be attached to. */
function strongestSelection([level, ...inner]: readonly IndexLevel[], set: string): string | undefined {
  for (const node of strengthOrder(level.root)) {
    const found = selectionOfNode(node, level, set);
    if (found !== undefined) return found;
    if (node !== level.inner || inner.length === 0) continue;
    const within = strongestSelection(inner, set);
    if (within !== undefined) return within;
  }
  return undefined;
}

function selectionOfNode(node: PrimIndexNode, { root, path }: IndexLevel, set: string): string | undefined {
  if (node.isInert) return undefined;
  const own = node === root ? path : mapToSource(node.mapToRoot, path);
  if (own === undefined) return undefined;
  const plain = stripVariants(node.path);
  if (own === plain) return selectionAt(node.opinions, set);
  const stored = node.arc.kind === 'variant' && own.startsWith(plain) ? node.path + own.slice(plain.length) : own;
  return selectionAt(opinionsAt(node.stack, stored), set);
}
