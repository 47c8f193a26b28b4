import type { GraphDocument } from '../../../graph/document/document.ts';
import { GROUP } from '../../../graph/document/structuralTypes.ts';
import type { NodeResult } from '../../../graph/evaluation/resultCache.ts';
import { firstOutputOf } from '../../../nodes/project/outputChain.ts';
import type { NodeResults } from './problems.ts';

/** Result of a node, by its id in the evaluation; for a group, that of its first output. */
export function nodeResultOf(
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
