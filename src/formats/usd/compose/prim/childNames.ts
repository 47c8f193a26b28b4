import { nameOf, parentOf } from '../../layer/primPaths.ts';
import { inOrder } from '../layers/listOps.ts';
import { isInstance } from '../primIndex/instances.ts';
import type { PrimIndexNode } from '../primIndex/primIndexNode.ts';

/** Child names in order: from the weakest site to the strongest, new names last. In an instance only those from its own arcs. */
export function childNames(index: PrimIndexNode): readonly string[] {
  if (isLeaf(index)) return NO_NAMES;
  let names = new Set<string>();
  const gone = new Set<string>();
  const visit = (node: PrimIndexNode, isLocal: boolean): void => {
    const local = isLocal && !node.isDirect;
    for (let i = node.children.length - 1; i >= 0; i--) visit(node.children[i], local);
    names = relocatedNames(node, names, gone);
    if (!node.isInert && !local) names = withLayerNames(node, names);
  };
  visit(index, isInstance(index));
  for (const name of gone) names.delete(name);
  return [...names];
}

const NO_NAMES: readonly string[] = [];

const isLeaf = ({ children, opinions, stack }: PrimIndexNode): boolean =>
  children.length === 0 && !stack.relocates && opinions.every(({ spec }) => spec.children.size === 0);

function withLayerNames(node: PrimIndexNode, names: Set<string>): Set<string> {
  let all = names;
  for (let i = node.opinions.length - 1; i >= 0; i--) {
    const { spec, from } = node.opinions[i];
    if (!from.source.isSession) for (const name of spec.children.keys()) all.add(name);
    if (spec.childOrder) all = new Set(inOrder([...all], spec.childOrder, (name) => name));
  }
  return all;
}

/** Applies the relocates of the node's layers: names are removed, added or renamed in place. */
function relocatedNames(node: PrimIndexNode, names: Set<string>, gone: Set<string>): Set<string> {
  const moves = node.stack.relocates?.byParent.get(node.path);
  if (!moves) return names;
  /** New name by old; undefined if moved away. No relocate starts where another ends. */
  const called = new Map<string, string | undefined>([...names].map((name) => [name, name]));
  const taken = new Set(names);
  const come: string[] = [];
  for (const [source, target] of moves) {
    const to = target !== '' && parentOf(target) === node.path ? nameOf(target) : undefined;
    const from = parentOf(source) === node.path ? nameOf(source) : undefined;
    const isNew = to !== undefined && !taken.has(to);
    if (from !== undefined) {
      if (called.has(from)) {
        called.set(from, isNew ? to : undefined);
        taken.delete(from);
        if (isNew) taken.add(to);
      }
      gone.add(from);
    } else if (isNew) come.push(to);
    if (to !== undefined) gone.delete(to);
  }
  return new Set([...[...called.values()].filter((name) => name !== undefined), ...come.sort()]);
}
