import type { NodeResult } from '../../../graph/evaluation/resultCache.ts';
import type { NodeProblem } from '../../../graph/nodeType.ts';

export type NodeResults = ReadonlyMap<string, NodeResult>;

/** The first problem of each node, and of each group that contains one, by the ids of the evaluation. */
export function problemsByNode(results: NodeResults): ReadonlyMap<string, NodeProblem> {
  const found = new Map<string, NodeProblem>();
  for (const [name, result] of results) {
    if (result.status !== 'failed') continue;
    const steps = name.split('/');
    for (let depth = steps.length; depth > 0; depth--) {
      const holder = steps.slice(0, depth).join('/');
      if (!found.has(holder)) found.set(holder, result.problem);
    }
  }
  return found;
}
