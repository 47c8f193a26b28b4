import {
  type Graph,
  type GraphDocument,
  type GraphNode,
  type GroupSocket,
  type NodeGroup,
  own,
} from '../document/document.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupKeyOf } from '../document/structuralTypes.ts';
import type { NodeType, ParamSpec, Registry, Socket } from '../nodeType.ts';

/** A level of a document: the document's own graph or the inside of a group. */
export interface GraphLevel {
  readonly document: GraphDocument;
  readonly graph: Graph;
  /** Id of the group; absent for the document's own level. */
  readonly group?: string;
}

export interface NodeSockets {
  /** Including the node's parameters, under their names. */
  readonly inputs: Readonly<Record<string, Socket>>;
  readonly outputs: Readonly<Record<string, Socket>>;
}

export function levelOf(document: GraphDocument, group?: string): GraphLevel | undefined {
  if (group === undefined) return { document, graph: document };
  const graph = own(document.groups, group);
  return graph && { document, graph, group };
}

export const levelsOf = (document: GraphDocument): GraphLevel[] => [
  { document, graph: document },
  ...Object.entries(document.groups).map(([group, graph]) => ({ document, graph, group })),
];

/** Sockets of a node in its level; undefined if its type or group does not exist. */
export function socketsOf(
  { document, group }: GraphLevel,
  node: GraphNode,
  registry: Registry,
): NodeSockets | undefined {
  if (node.type === GROUP) return groupSockets(own(document.groups, groupKeyOf(node)))?.outside;
  const parentGroup = group === undefined ? undefined : own(document.groups, group);
  if (node.type === GROUP_INPUT) return groupSockets(parentGroup)?.entry;
  if (node.type === GROUP_OUTPUT) return groupSockets(parentGroup)?.exit;
  const type = own(registry, node.type);
  return type && socketsOfType(type);
}

/** The input that an edge refers to: `name`, or `name.2` for inputs of many edges. */
export function inputSocket({ inputs }: NodeSockets, name: string): Socket | undefined {
  const { base, number } = inputName(name);
  const socket = own(inputs, base);
  return socket && Boolean(socket.many) === (number !== undefined) ? socket : undefined;
}

/** `name.2` → `name` and 2. */
export function inputName(name: string): { readonly base: string; readonly number?: number } {
  const dot = name.indexOf('.');
  return dot < 0 ? { base: name } : { base: name.slice(0, dot), number: Number(name.slice(dot + 1)) };
}

const PARAM_TYPES: Readonly<Record<ParamSpec['kind'], string | undefined>> = {
  number: 'number',
  boolean: 'number',
  choice: 'text',
  text: 'text',
  vector: 'vector',
  color: 'color',
  list: undefined,
};

const typeSocketsCache = new WeakMap<object, NodeSockets>();

/** Sockets of a type, including one for each drivable parameter. */
export function socketsOfType(type: NodeType): NodeSockets {
  const known = typeSocketsCache.get(type);
  if (known) return known;
  const params = Object.entries(type.params).flatMap(([name, { kind, title }]) => {
    const socket = PARAM_TYPES[kind];
    return socket === undefined || own(type.inputs, name)
      ? []
      : [[name, { type: socket, title, optional: true }] as const];
  });
  const sockets = { inputs: { ...type.inputs, ...Object.fromEntries(params) }, outputs: type.outputs };
  typeSocketsCache.set(type, sockets);
  return sockets;
}

/** Sockets of a group, for its instances and for the group input and output nodes inside. */
interface GroupSockets {
  readonly outside: NodeSockets;
  readonly entry: NodeSockets;
  readonly exit: NodeSockets;
}

const groupSocketsCache = new WeakMap<object, GroupSockets>();

function groupSockets(group: NodeGroup | undefined): GroupSockets | undefined {
  if (!group) return undefined;
  const known = groupSocketsCache.get(group);
  if (known) return known;
  const [inputs, outputs] = [socketTable(group.inputs), socketTable(group.outputs)];
  const sockets = {
    outside: { inputs, outputs },
    entry: { inputs: {}, outputs: inputs },
    exit: { inputs: outputs, outputs: {} },
  };
  groupSocketsCache.set(group, sockets);
  return sockets;
}

const socketTable = (sockets: readonly GroupSocket[]): Record<string, Socket> =>
  Object.fromEntries(
    sockets.map(({ name, type, title = name }): [string, Socket] => [name, { type, title, optional: true }]),
  );
