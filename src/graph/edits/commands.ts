import { current, enablePatches, type Patch, produceWithPatches } from 'immer';
import { type Message, msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import {
  type EventMark,
  edgeKey,
  type FileReference,
  type Graph,
  type GraphDocument,
  type GraphEdge,
  type GraphFrame,
  type GraphNote,
  graphIn,
  IDENTIFIER,
  type NodeGroup,
  own,
  type ParamValue,
} from '../document/document.ts';
import { findFault } from '../document/integrity.ts';

enablePatches();

/** A place on the canvas, y downwards [px]. */
export type CanvasPoint = readonly [x: number, y: number];

/** An edit of a document; applies to the document's own level unless wrapped in `inside` a group. */
export type Command =
  | {
      readonly kind: 'add-node';
      readonly node: string;
      readonly type: string;
      readonly at: CanvasPoint;
      readonly params?: Readonly<Record<string, ParamValue>>;
    }
  /** Including their edges. */
  | { readonly kind: 'remove-nodes'; readonly nodes: readonly string[] }
  | { readonly kind: 'move-nodes'; readonly to: Readonly<Record<string, CanvasPoint>> }
  | { readonly kind: 'connect'; readonly edge: GraphEdge }
  | { readonly kind: 'disconnect'; readonly to: GraphEdge['to'] }
  /** Without a value the parameter is reset to its default. */
  | { readonly kind: 'set-param'; readonly node: string; readonly param: string; readonly value?: ParamValue }
  /** Without a title the type's title is used again. */
  | { readonly kind: 'rename'; readonly node: string; readonly title?: string }
  | { readonly kind: 'mute'; readonly nodes: readonly string[]; readonly muted: boolean }
  | { readonly kind: 'collapse'; readonly nodes: readonly string[]; readonly collapsed: boolean }
  /** Adds, changes, or without a value removes; also for the following ones. */
  | { readonly kind: 'set-note'; readonly note: string; readonly value?: GraphNote }
  | { readonly kind: 'set-frame'; readonly frame: string; readonly value?: GraphFrame }
  | { readonly kind: 'set-group'; readonly group: string; readonly value?: NodeGroup }
  /** Title or description of the project. */
  | { readonly kind: 'describe'; readonly what: 'title' | 'lookFor'; readonly value?: string }
  | { readonly kind: 'set-file'; readonly file: string; readonly value?: FileReference }
  /** All marked events of the project. */
  | { readonly kind: 'set-marks'; readonly marks: readonly EventMark[] }
  /** Adds many nodes at once with everything that belongs to them; all keys must be free. */
  | { readonly kind: 'insert'; readonly graph: Graph }
  | { readonly kind: 'inside'; readonly group: string; readonly command: Command }
  | { readonly kind: 'batch'; readonly commands: readonly Command[] };

/** A changed document, and what changed. */
export interface Edit {
  /** The new document; the old one is unchanged. */
  readonly document: GraphDocument;
  /** From the old document to the new one. */
  readonly patches: readonly Patch[];
  /** From the new document to the old one. */
  readonly inverse: readonly Patch[];
}

/** The tables of a graph, and what they hold. */
const GRAPH_TABLES = {
  nodes: msg`node`,
  layout: msg`node`,
  edges: msg`edge`,
  notes: msg`note`,
  frames: msg`frame`,
};
type GraphTable = keyof typeof GRAPH_TABLES;

/**
 * A command that is not valid for the document.
 * @example
 * try {
 *   applyCommand(emptyDocument(), { kind: 'set-param', node: 'none', param: 'speed', value: 1 });
 * } catch (error) {
 *   error instanceof CommandError; // true
 * }
 */
export class CommandError extends MessageError {
  constructor(text: Message) {
    super(text);
    this.name = 'CommandError';
  }
}

/**
 * Throws a CommandError without effect if the resulting document would be invalid.
 * @example
 * const command: Command = { kind: 'add-node', node: 'a', type: 'number', at: [0, 0] };
 * const { document } = applyCommand(emptyDocument(), command);
 * document.nodes.a.type; // 'number'
 */
export function applyCommand(document: GraphDocument, command: Command): Edit {
  const [next, patches, inverse] = produceWithPatches(document, (draft) => applyToDocument(draft, draft, command));
  const fault = needsIntegrityCheck(command) ? findFault(next) : undefined;
  if (fault) throw new CommandError(fault);
  return { document: next, patches, inverse };
}

/** Whether the whole document must be checked after a command: number of nodes, cycles of groups, and names. */
function needsIntegrityCheck(command: Command): boolean {
  if (command.kind === 'batch') return command.commands.some(needsIntegrityCheck);
  if (command.kind === 'inside') return needsIntegrityCheck(command.command);
  if (command.kind === 'set-param') return command.param === 'group';
  return ['add-node', 'insert', 'set-group', 'set-frame', 'set-marks'].includes(command.kind);
}

function applyToDocument(document: GraphDocument, level: Graph, command: Command): void {
  switch (command.kind) {
    case 'batch':
      for (const part of command.commands) applyToDocument(document, level, part);
      break;
    case 'inside': {
      const inner = graphIn(document, command.group);
      if (!inner) throw new CommandError(msg`there is no group "${command.group}"`);
      applyToDocument(document, inner, command.command);
      break;
    }
    case 'set-group':
      setEntry(document.groups, command.group, command.value);
      break;
    case 'describe':
      setEntry(document, command.what, command.value || undefined);
      break;
    case 'set-file':
      setEntry(document.files, command.file, command.value);
      break;
    case 'set-marks':
      setEntry(document, 'marks', command.marks.length > 0 ? command.marks : undefined);
      break;
    default:
      applyToLevel(level, command);
  }
}

type LevelCommand = Exclude<
  Command,
  { readonly kind: 'batch' | 'inside' | 'set-group' | 'describe' | 'set-file' | 'set-marks' }
>;

function applyToLevel(level: Graph, command: LevelCommand): void {
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
        requireNode(level, node);
        level.layout[node] = cloneData(at);
      }
      break;
    case 'connect':
      requireNode(level, command.edge.from.node);
      requireNode(level, command.edge.to.node);
      setEntry(level.edges, edgeKey(command.edge.to), command.edge);
      break;
    case 'disconnect':
      setEntry(level.edges, edgeKey(command.to), undefined);
      break;
    case 'set-note':
      setEntry(level.notes, command.note, command.value);
      break;
    case 'set-frame':
      setEntry(level.frames, command.frame, command.value);
      break;
    default:
      applyToNodes(level, command);
  }
}

type NodeCommand = Extract<Command, { readonly kind: 'set-param' | 'rename' | 'mute' | 'collapse' }>;

function applyToNodes(level: Graph, command: NodeCommand): void {
  switch (command.kind) {
    case 'set-param':
      setEntry(requireNode(level, command.node).params, command.param, command.value);
      break;
    case 'rename':
      setEntry(requireNode(level, command.node), 'title', command.title || undefined);
      break;
    case 'mute':
      for (const id of command.nodes) setEntry(requireNode(level, id), 'muted', command.muted || undefined);
      break;
    case 'collapse':
      for (const id of command.nodes) setEntry(requireNode(level, id), 'collapsed', command.collapsed || undefined);
  }
}

/** Sets an entry of a table, or removes it without a value; equal values are not touched. */
function setEntry<Table extends object, Key extends keyof Table & string>(
  table: Table,
  key: Key,
  value: Table[Key] | undefined,
): void {
  if (value === undefined) delete table[key];
  else if (!Object.hasOwn(table, key) || JSON.stringify(table[key]) !== JSON.stringify(value))
    table[key] = cloneData(value);
}

/** Deep copy of plain data, so that later edits do not modify the command's value. */
function cloneData<T>(value: T): T {
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.map(cloneData) as T;
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, cloneData(item)])) as T;
}

function addNode(level: Graph, { node, type, at, params = {} }: Extract<Command, { kind: 'add-node' }>): void {
  if (!IDENTIFIER.test(node)) throw new CommandError(msg`"${node}" cannot be a node's name: letters, digits, - and _`);
  assertKeyFree(level.nodes, node, 'nodes');
  level.nodes[node] = { type, params: cloneData(params) };
  level.layout[node] = cloneData(at);
}

function insert(level: Graph, graph: Graph): void {
  for (const table of Object.keys(GRAPH_TABLES) as GraphTable[]) {
    for (const key of Object.keys(graph[table])) assertKeyFree(level[table], key, table);
    Object.assign(level[table], cloneData(graph[table]));
  }
}

function assertKeyFree(taken: object, key: string, table: GraphTable): void {
  if (Object.hasOwn(taken, key)) throw new CommandError(msg`there is already a ${GRAPH_TABLES[table]} "${key}"`);
}

function removeNodes(level: Graph, ids: readonly string[]): void {
  const gone = new Set(ids);
  for (const id of gone) {
    requireNode(level, id);
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

function requireNode(level: Graph, id: string) {
  const node = own(level.nodes, id);
  if (!node) throw new CommandError(msg`there is no node "${id}"`);
  return node;
}
