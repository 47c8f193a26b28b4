import { type Draft, enablePatches, type Patch, produceWithPatches } from 'immer';
import { edgeKey, type GraphDocument, type GraphEdge, type ParamValue } from './document.ts';

enablePatches();

/** Every edit of a document is one of these. */
export type Command =
  | { readonly kind: 'add-node'; readonly node: string; readonly type: string; readonly at: readonly [number, number] }
  | { readonly kind: 'remove-node'; readonly node: string }
  | { readonly kind: 'move-node'; readonly node: string; readonly to: readonly [number, number] }
  | { readonly kind: 'connect'; readonly edge: GraphEdge }
  | { readonly kind: 'disconnect'; readonly to: GraphEdge['to'] }
  /** Without a value the parameter goes back to its default. */
  | { readonly kind: 'set-param'; readonly node: string; readonly param: string; readonly value?: ParamValue }
  | { readonly kind: 'batch'; readonly commands: readonly Command[] };

export interface Edit {
  readonly document: GraphDocument;
  readonly patches: readonly Patch[];
  /** Applied to the new document they give exactly the old one. */
  readonly inverse: readonly Patch[];
}

/** A command that does not fit the document it was given for. */
export class CommandError extends Error {
  constructor(message: string) {
    super(message);
    this.name = 'CommandError';
  }
}

export function applyCommand(document: GraphDocument, command: Command): Edit {
  const [next, patches, inverse] = produceWithPatches(document, (draft) => change(draft, command));
  return { document: next, patches, inverse };
}

function change(draft: Draft<GraphDocument>, command: Command): void {
  switch (command.kind) {
    case 'batch':
      for (const part of command.commands) change(draft, part);
      break;
    case 'add-node':
      if (draft.nodes[command.node]) throw new CommandError(`there is already a node "${command.node}"`);
      draft.nodes[command.node] = { type: command.type, params: {} };
      draft.layout[command.node] = [...command.at];
      break;
    case 'remove-node':
      removeNode(draft, command.node);
      break;
    case 'move-node':
      nodeOf(draft, command.node);
      draft.layout[command.node] = [...command.to];
      break;
    case 'connect':
      nodeOf(draft, command.edge.from.node);
      nodeOf(draft, command.edge.to.node);
      draft.edges[edgeKey(command.edge.to)] = { from: { ...command.edge.from }, to: { ...command.edge.to } };
      break;
    case 'disconnect':
      delete draft.edges[edgeKey(command.to)];
      break;
    case 'set-param':
      setParam(draft, command);
  }
}

function removeNode(draft: Draft<GraphDocument>, id: string): void {
  nodeOf(draft, id);
  delete draft.nodes[id];
  delete draft.layout[id];
  for (const [key, edge] of Object.entries(draft.edges)) {
    if (edge.from.node === id || edge.to.node === id) delete draft.edges[key];
  }
}

function setParam(draft: Draft<GraphDocument>, command: Extract<Command, { kind: 'set-param' }>): void {
  const { params } = nodeOf(draft, command.node);
  if (command.value === undefined) delete params[command.param];
  else if (typeof command.value === 'object') params[command.param] = [...command.value] as string[] | number[];
  else params[command.param] = command.value;
}

function nodeOf(draft: Draft<GraphDocument>, id: string) {
  const node = draft.nodes[id];
  if (!node) throw new CommandError(`there is no node "${id}"`);
  return node;
}
