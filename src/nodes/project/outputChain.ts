import { type FlatAlias, type FlatGraph, type FlatNode, flatten } from '../../graph/analysis/flatten.ts';
import { DocumentError, type GraphDocument, type ParamValue } from '../../graph/document/document.ts';
import { nodeLibrary } from '../library.ts';

/**
 * The node whose image is the project's: the first output node.
 * @example
 * outputNodeId(newProject('street.usda')); // 'output'
 */
export const outputNodeId = ({ nodes }: GraphDocument): string | undefined =>
  Object.entries(nodes).find(([, { type }]) => type === 'output')?.[0];

interface OutputChain extends Pick<GraphDocument, 'edges' | 'groups'> {
  readonly flat: FlatGraph | undefined;
  readonly chain: readonly FlatNode[];
}
const chainCache = new WeakMap<GraphDocument['nodes'], OutputChain>();

function analyzedDocument(document: GraphDocument): OutputChain {
  const { nodes, edges, groups } = document;
  const cached = chainCache.get(nodes);
  if (cached?.edges === edges && cached.groups === groups) return cached;
  const flat = tryFlatten(document);
  const fresh = { edges, groups, flat, chain: upstreamNodes(flat, outputNodeId(document)) };
  chainCache.set(nodes, fresh);
  return fresh;
}

/**
 * The nodes that feed a project's output, including it, nearest first: groups expanded, muted nodes skipped, ids as in
 * evaluations. Empty if there is no output.
 */
export const nodesFeedingOutput = (document: GraphDocument): readonly FlatNode[] => analyzedDocument(document).chain;

/** The output that the first output of a group or of another structural node stands for, by its evaluation id. */
export const firstOutputOf = (document: GraphDocument, id: string): FlatAlias | undefined =>
  analyzedDocument(document).flat?.aliases.get(id);

/** The node of a type that is nearest to the output. */
export const nearestToOutput = (document: GraphDocument, type: string): FlatNode | undefined =>
  nodesFeedingOutput(document).find((node) => node.type === type);

/** The parameters of all read nodes, by id. */
export const readNodeParams = (document: GraphDocument): Readonly<Record<string, FlatNode['params']>> =>
  Object.fromEntries(
    nodesFeedingOutput(document).flatMap(({ id, type, params }) => (type === 'read' ? [[id, params]] : [])),
  );

export const readSource = (params: Readonly<Record<string, ParamValue>> | undefined): string =>
  String(params?.source ?? '');

function upstreamNodes(flat: FlatGraph | undefined, output: string | undefined): FlatNode[] {
  const first = output === undefined ? undefined : flat?.nodes.get(output);
  const chain = new Set(first ? [first] : []);
  // A Set's iteration includes elements added during it.
  for (const { inputs } of chain) {
    for (const source of [...inputs.values()].flat()) {
      const node = source.kind === 'output' ? flat?.nodes.get(source.node) : undefined;
      if (node) chain.add(node);
    }
  }
  return [...chain];
}

/** Documents whose groups expand beyond the limit feed nothing; the evaluation reports the error. */
function tryFlatten(document: GraphDocument): FlatGraph | undefined {
  try {
    return flatten(document, nodeLibrary);
  } catch (error) {
    if (error instanceof DocumentError) return undefined;
    throw error;
  }
}
