import type { NodeResult } from '../../../graph/evaluation/resultCache.ts';
import type { NodeProblem } from '../../../graph/nodeType.ts';
import { inEnglish } from '../../../messages/message.ts';
import type { Diagnostic } from '../../../scene/types.ts';

export type NodeResults = ReadonlyMap<string, NodeResult>;

/**
 * The first problem of each node, and of each group that contains one, by the ids of the evaluation; of a node that has a
 * result, the first warning about itself. Errors precede warnings.
 */
export function problemsByNode(results: NodeResults): ReadonlyMap<string, NodeProblem> {
  const found = new Map<string, NodeProblem>();
  const add = (name: string, problem: NodeProblem): void => {
    const steps = name.split('/');
    for (let depth = steps.length; depth > 0; depth--) {
      const holder = steps.slice(0, depth).join('/');
      if (!found.has(holder)) found.set(holder, problem);
    }
  };
  for (const [name, result] of results) if (result.status === 'failed') add(name, result.problem);
  for (const [name, result] of results) {
    const warning = result.status === 'done' ? warningAbout(name, Object.values(result.outputs)) : undefined;
    if (warning) add(name, warning);
  }
  return found;
}

/** The first warning in the scenes among a node's outputs whose place is that node, or a parameter of it. */
function warningAbout(node: string, outputs: readonly unknown[]): NodeProblem | undefined {
  const notes = outputs.flatMap((output) => diagnosticsOf(output));
  const own = notes.find(
    ({ severity, place }) =>
      severity === 'warning' && typeof place === 'string' && (place === node || place.startsWith(`${node}.`)),
  );
  return own && { severity: 'warning', code: own.code, place: inEnglish(own.place), message: own.message };
}

const diagnosticsOf = (output: unknown): readonly Diagnostic[] =>
  (output as { readonly scene?: { readonly diagnostics?: readonly Diagnostic[] } } | undefined)?.scene?.diagnostics ??
  [];
