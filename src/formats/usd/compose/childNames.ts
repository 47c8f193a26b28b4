import { isInstance } from './instances.ts';
import { inOrder } from './listOps.ts';
import type { Node } from './node.ts';
import { nameOf, parentOf } from './paths.ts';

/**
 * The names of the prims in a prim, in their order: from the weakest site to the strongest, what is new comes last. In
 * an instance is only what its own arcs bring.
 */
export function childNames(index: Node): string[] {
  let names: string[] = [];
  const gone = new Set<string>();
  const visit = (node: Node, isLocal: boolean): void => {
    const local = isLocal && !node.isDirect;
    for (const child of [...node.children].reverse()) visit(child, local);
    names = moved(node, names, gone);
    if (!node.isInert && !local) names = withLocal(node, names);
  };
  visit(index, isInstance(index));
  return names.filter((name) => !gone.has(name));
}

function withLocal(node: Node, names: readonly string[]): string[] {
  let all = [...names];
  for (const { spec, from } of [...node.opinions].reverse()) {
    const known = new Set(all);
    if (!from.source.isSession) for (const name of spec.children.keys()) if (!known.has(name)) all.push(name);
    if (spec.childOrder) all = inOrder(all, spec.childOrder, (name) => name);
  }
  return all;
}

/** Relocates of the node's layers: some names go, others come, and those that stay in the prim change in place. */
function moved(node: Node, names: readonly string[], gone: Set<string>): string[] {
  const { relocates } = node.stack;
  if (!relocates) return [...names];
  let out = [...names];
  const come: string[] = [];
  for (const [source, target] of relocates.bySource) {
    const to = target !== '' && parentOf(target) === node.path ? nameOf(target) : undefined;
    const from = parentOf(source) === node.path ? nameOf(source) : undefined;
    if (from !== undefined) {
      const renamed = to !== undefined && !out.includes(to);
      out = out.flatMap((name) => (name !== from ? [name] : renamed ? [to] : []));
      gone.add(from);
    } else if (to !== undefined && !out.includes(to)) come.push(to);
    if (to !== undefined) gone.delete(to);
  }
  return [...out, ...come.sort()];
}
