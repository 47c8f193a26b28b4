import type { GraphDocument } from '../../graph/document.ts';
import type { NodeResult } from '../../graph/results.ts';
import { GROUP } from '../../graph/structure.ts';
import { firstOutputOf } from '../../nodes/chain.ts';
import type { NodeResults } from './problems.ts';

/** What an evaluation made of a node, by its flat name; of a group, what its first output gives. */
export function outcomeOf(
  results: NodeResults,
  document: GraphDocument,
  name: string,
  node: { readonly type: string; readonly muted?: boolean } | undefined,
): NodeResult | undefined {
  if (node?.type !== GROUP || node.muted) return results.get(name);
  const { output, source } = firstOutputOf(document, name) ?? {};
  if (output === undefined || source?.kind !== 'output') return undefined;
  const result = results.get(source.node);
  if (result?.status === 'failed') return { status: 'blocked', by: source.node };
  return result?.status === 'done' ? { status: 'done', outputs: { [output]: result.outputs[source.output] } } : result;
}
