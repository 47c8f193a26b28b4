import { current, enablePatches, type Patch, produceWithPatches } from 'immer';
import {
  edgeKey,
  type FileReference,
  type Frame,
  type Graph,
  type GraphDocument,
  type GraphEdge,
  type Group,
  graphIn,
  IDENTIFIER,
  type Note,
  own,
  type ParamValue,
} from './document.ts';
import { faultIn } from './integrity.ts';

enablePatches();

export type Point = readonly [x: number, y: number];

/** Every edit of a document is one of these; where it has levels, of its own unless it is said to be `inside` a group. */
export type Command =
  | {
      readonly kind: 'add-node';
      readonly node: string;
      readonly type: string;
      readonly at: Point;
      readonly params?: Readonly<Record<string, ParamValue>>;
    }
  /** With their edges. */
  | { readonly kind: 'remove-nodes'; readonly nodes: readonly string[] }
  | { readonly kind: 'move-nodes'; readonly to: Readonly<Record<string, Point>> }
  | { readonly kind: 'connect'; readonly edge: GraphEdge }
  | { readonly kind: 'disconnect'; readonly to: GraphEdge['to'] }
  /** Without a value the parameter goes back to its default. */
  | { readonly kind: 'set-param'; readonly node: string; readonly param: string; readonly value?: ParamValue }
  /** Without a title the node goes by its type's again. */
  | { readonly kind: 'rename'; readonly node: string; readonly title?: string }
  | { readonly kind: 'mute'; readonly nodes: readonly string[]; readonly muted: boolean }
  | { readonly kind: 'collapse'; readonly nodes: readonly string[]; readonly collapsed: boolean }
  /** Adds, changes, or without a value removes; so do those that follow. */
  | { readonly kind: 'set-note'; readonly note: string; readonly value?: Note }
  | { readonly kind: 'set-frame'; readonly frame: string; readonly value?: Frame }
  | { readonly kind: 'set-group'; readonly group: string; readonly value?: Group }
  /** What the project is called, and what there is to be seen in it. */
  | { readonly kind: 'describe'; readonly what: 'title' | 'lookFor'; readonly value?: string }
  | { readonly kind: 'set-file'; readonly file: string; readonly value?: FileReference }
  /** Adds many nodes at once, with all that belongs to them; none of the keys is taken. */
  | { readonly kind: 'insert'; readonly graph: Graph }
  | { readonly kind: 'inside'; readonly group: string; readonly command: Command }
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

/** Throws a CommandError, and changes nothing, where the document that it would give could not be read again. */
export function applyCommand(document: GraphDocument, command: Command): Edit {
  const [next, patches, inverse] = produceWithPatches(document, (draft) => change(draft, draft, command));
  const fault = isRisky(command) ? faultIn(next) : undefined;
  if (fault) throw new CommandError(fault);
  return { document: next, patches, inverse };
}

/** Whether the whole document has to be looked at, to be sure of it: how many nodes it has, and that groups hold no circles. */
function isRisky(command: Command): boolean {
  if (command.kind === 'batch') return command.commands.some(isRisky);
  if (command.kind === 'inside') return isRisky(command.command);
  if (command.kind === 'set-param') return command.param === 'group';
  return ['add-node', 'insert', 'set-group', 'set-frame'].includes(command.kind);
}

function change(document: GraphDocument, level: Graph, command: Command): void {
  switch (command.kind) {
    case 'batch':
      for (const part of command.commands) change(document, level, part);
      break;
    case 'inside': {
      const inner = graphIn(document, command.group);
      if (!inner) throw new CommandError(`there is no group "${command.group}"`);
      change(document, inner, command.command);
      break;
    }
    case 'set-group':
      put(document.groups, command.group, command.value);
      break;
    case 'describe':
      put(document, command.what, command.value || undefined);
      break;
    case 'set-file':
      put(document.files, command.file, command.value);
      break;
    default:
      changeLevel(level, command);
  }
}

type LevelCommand = Exclude<Command, { readonly kind: 'batch' | 'inside' | 'set-group' | 'describe' | 'set-file' }>;

function changeLevel(level: Graph, command: LevelCommand): void {
  switch (command.kind) {
    case 'add-node':
      addNode(level, command);
      break;
    case 'insert':
      insert(level, command.graph);
      break;
    case 'remove-nodes':
      removeNodes(level, command.nodes);
      break;
    case 'move-nodes':
      for (const [node, at] of Object.entries(command.to)) {
        nodeOf(level, node);
        level.layout[node] = copy(at);
      }
      break;
    case 'connect':
      nodeOf(level, command.edge.from.node);
      nodeOf(level, command.edge.to.node);
      put(level.edges, edgeKey(command.edge.to), command.edge);
      break;
    case 'disconnect':
      put(level.edges, edgeKey(command.to), undefined);
      break;
    case 'set-note':
      put(level.notes, command.note, command.value);
      break;
    case 'set-frame':
      put(level.frames, command.frame, command.value);
      break;
    default:
      changeNodes(level, command);
  }
}

type NodeCommand = Extract<Command, { readonly kind: 'set-param' | 'rename' | 'mute' | 'collapse' }>;

function changeNodes(level: Graph, command: NodeCommand): void {
  switch (command.kind) {
    case 'set-param':
      put(nodeOf(level, command.node).params, command.param, command.value);
      break;
    case 'rename':
      put(nodeOf(level, command.node), 'title', command.title || undefined);
      break;
    case 'mute':
      for (const id of command.nodes) put(nodeOf(level, id), 'muted', command.muted || undefined);
      break;
    case 'collapse':
      for (const id of command.nodes) put(nodeOf(level, id), 'collapsed', command.collapsed || undefined);
  }
}

/** Sets an entry of a table, or takes it out where there is no value. What is the same already is left alone. */
function put<Table extends object, Key extends keyof Table & string>(
  table: Table,
  key: Key,
  value: Table[Key] | undefined,
): void {
  if (value === undefined) delete table[key];
  else if (!Object.hasOwn(table, key) || JSON.stringify(table[key]) !== JSON.stringify(value)) table[key] = copy(value);
}

/** Of plain data: what a later part of the same command changes must not be the command's own. */
function copy<T>(value: T): T {
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.map(copy) as T;
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, copy(item)])) as T;
}

function addNode(level: Graph, { node, type, at, params = {} }: Extract<Command, { kind: 'add-node' }>): void {
  if (!IDENTIFIER.test(node)) throw new CommandError(`"${node}" cannot be a node's name: letters, digits, - and _`);
  refuseTaken(level.nodes, node, 'node');
  level.nodes[node] = { type, params: copy(params) };
  level.layout[node] = copy(at);
}

function insert(level: Graph, graph: Graph): void {
  for (const table of ['nodes', 'layout', 'edges', 'notes', 'frames'] as const) {
    for (const key of Object.keys(graph[table])) refuseTaken(level[table], key, table);
    Object.assign(level[table], copy(graph[table]));
  }
}

function refuseTaken(table: object, key: string, what: string): void {
  if (Object.hasOwn(table, key)) throw new CommandError(`there is already a ${what.replace(/s$/, '')} "${key}"`);
}

function removeNodes(level: Graph, ids: readonly string[]): void {
  const gone = new Set(ids);
  for (const id of gone) {
    nodeOf(level, id);
    delete level.nodes[id];
    delete level.layout[id];
  }
  for (const [key, { from, to }] of Object.entries(current(level.edges))) {
    if (gone.has(from.node) || gone.has(to.node)) delete level.edges[key];
  }
  for (const [key, frame] of Object.entries(level.frames)) {
    const nodes = frame.nodes.filter((id) => !gone.has(id));
    if (nodes.length === 0) delete level.frames[key];
    else if (nodes.length < frame.nodes.length) level.frames[key]!.nodes = nodes;
  }
}

function nodeOf(level: Graph, id: string) {
  const node = own(level.nodes, id);
  if (!node) throw new CommandError(`there is no node "${id}"`);
  return node;
}
