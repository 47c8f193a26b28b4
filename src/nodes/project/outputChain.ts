import { type FlatAlias, type FlatGraph, type FlatNode, flatten } from '../../graph/analysis/flatten.ts';
import { DocumentError, type GraphDocument, type ParamValue } from '../../graph/document/document.ts';
import { nodeLibrary } from '../library.ts';

/** The node whose image is the project's: its first output. */
export const outputNodeId = ({ nodes }: GraphDocument): string | undefined =>
  Object.entries(nodes).find(([, { type }]) => type === 'output')?.[0];

interface OutputChain extends Pick<GraphDocument, 'edges' | 'groups'> {
  readonly flat: FlatGraph | undefined;
  readonly chain: readonly FlatNode[];
}
const chainCache = new WeakMap<GraphDocument['nodes'], OutputChain>();

function analyzedDocument(document: GraphDocument): OutputChain {
  const { nodes, edges, groups } = document;
  const known = chainCache.get(nodes);
  if (known?.edges === edges && known.groups === groups) return known;
  const flat = tryFlatten(document);
  const fresh = { edges, groups, flat, chain: upstreamNodes(flat, outputNodeId(document)) };
  chainCache.set(nodes, fresh);
  return fresh;
}

/**
 * The nodes that feed a project's output, with it, the nearest first: groups opened out, muted nodes left out, ids as an evaluation has
 * them. Empty where there is no output.
 */
export const nodesFeedingOutput = (document: GraphDocument): readonly FlatNode[] => analyzedDocument(document).chain;

/** What the first output of a group is, or of another node that computes nothing, by its id as an evaluation has it. */
export const firstOutputOf = (document: GraphDocument, id: string): FlatAlias | undefined =>
  analyzedDocument(document).flat?.aliases.get(id);

/** Of a type, the node that is nearest to the output. */
export const nearestToOutput = (document: GraphDocument, type: string): FlatNode | undefined =>
  nodesFeedingOutput(document).find((node) => node.type === type);

/** The nodes that read files, by id, with how they do. */
export const readNodeParams = (document: GraphDocument): Readonly<Record<string, FlatNode['params']>> =>
  Object.fromEntries(
    nodesFeedingOutput(document).flatMap(({ id, type, params }) => (type === 'read' ? [[id, params]] : [])),
  );

export const readSource = (params: Readonly<Record<string, ParamValue>> | undefined): string =>
  String(params?.source ?? '');

function upstreamNodes(flat: FlatGraph | undefined, output: string | undefined): FlatNode[] {
  const first = output === undefined ? undefined : flat?.nodes.get(output);
  const chain = new Set(first ? [first] : []);
  // What a set is given while it is gone through comes too.
  for (const { inputs } of chain) {
    for (const source of [...inputs.values()].flat()) {
      const node = source.kind === 'output' ? flat?.nodes.get(source.node) : undefined;
      if (node) chain.add(node);
    }
  }
  return [...chain];
}

/** Groups that open out to too much feed nothing; the evaluation says so. */
function tryFlatten(document: GraphDocument): FlatGraph | undefined {
  try {
    return flatten(document, nodeLibrary);
  } catch (error) {
    if (error instanceof DocumentError) return undefined;
    throw error;
  }
}
