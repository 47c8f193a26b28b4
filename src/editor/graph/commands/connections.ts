import { conversion } from '../../../graph/analysis/conversion.ts';
import { inferTypes, type LevelTypes } from '../../../graph/analysis/inferTypes.ts';
import { type GraphLevel, type NodeSockets, socketsOf, socketsOfType } from '../../../graph/analysis/sockets.ts';
import { edgeError, reachableFrom } from '../../../graph/analysis/validate.ts';
import { type Graph, type GraphEdge, own } from '../../../graph/document/document.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT } from '../../../graph/document/structuralTypes.ts';
import { ANY, type NodeType } from '../../../graph/nodeType.ts';
import type { LocalizedText } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { socketTitle } from '../../../nodes/titles.ts';
import { NEW_SOCKET } from '../cards/cardModel.ts';

/** One end of an edge whose other end is not chosen yet. */
export interface PendingConnection {
  readonly node: string;
  readonly side: 'inputs' | 'outputs';
  readonly socket: string;
}

export const oppositeSide = (side: PendingConnection['side']): PendingConnection['side'] =>
  side === 'inputs' ? 'outputs' : 'inputs';

/** The edge between a pending connection and a socket of the other side. */
export function edgeBetween({ node, side, socket }: PendingConnection, other: string, name: string): GraphEdge {
  return side === 'outputs'
    ? { from: { node, output: socket }, to: { node: other, input: name } }
    : { from: { node: other, output: name }, to: { node, input: socket } };
}

/** Returns a predicate: whether a socket fits the pending connection. Costly checks are cached. */
export function connectionCheck(
  level: GraphLevel,
  pendingEnd: PendingConnection,
): (node: string, socket: string) => boolean {
  const types = inferTypes(level, nodeLibrary);
  const held = typeAt(types, pendingEnd);
  const circles = nodesClosingCycle(level.graph, pendingEnd);
  const side = oppositeSide(pendingEnd.side);
  return (node, socket) => {
    if (circles.has(node)) return false;
    if (socket === NEW_SOCKET || pendingEnd.socket === NEW_SOCKET) return socket !== pendingEnd.socket;
    const type = types.typeOf(node, side, socket);
    if (type === undefined) return false;
    const [from, to] = pendingEnd.side === 'outputs' ? [held, type] : [type, held];
    if (!conversion(from, to)) return false;
    // Sockets of type `any` take their type from all connections, so the whole level must be inferred.
    const isSure =
      from !== ANY &&
      to !== ANY &&
      !isGeneric(level, node, side, socket) &&
      !isGeneric(level, pendingEnd.node, pendingEnd.side, pendingEnd.socket);
    return (
      isSure || edgeError(level.document, edgeBetween(pendingEnd, node, socket), nodeLibrary, level.group) === undefined
    );
  };
}

const typeAt = (types: LevelTypes, { node, side, socket }: PendingConnection): string =>
  types.typeOf(node, side, socket) ?? ANY;

/** Nodes to which an edge would close a cycle. */
function nodesClosingCycle(graph: Graph, { node, side }: PendingConnection): ReadonlySet<string> {
  if (side === 'inputs') return reachableFrom(graph, [node]);
  const turned = Object.entries(graph.edges).map(([key, { from, to }]): [string, GraphEdge] => [
    key,
    { from: { node: to.node, output: '' }, to: { node: from.node, input: '' } },
  ]);
  return reachableFrom({ edges: Object.fromEntries(turned) }, [node]);
}

function isGeneric(level: GraphLevel, id: string, side: keyof NodeSockets, name: string): boolean {
  const node = own(level.graph.nodes, id);
  const sockets = node && socketsOf(level, node, nodeLibrary);
  return sockets?.[side][name.split('.')[0]!]?.type === ANY;
}

/** A socket of a node that fits a pending connection. */
export interface SocketOption {
  readonly socket: string;
  readonly title: LocalizedText;
}

/** The sockets of a node that fit a pending connection; parameters last. */
export function socketOptions(level: GraphLevel, pendingEnd: PendingConnection, id: string): SocketOption[] {
  const node = own(level.graph.nodes, id);
  const sockets = node && socketsOf(level, node, nodeLibrary);
  if (!sockets) return [];
  const fits = connectionCheck(level, pendingEnd);
  const side = oppositeSide(pendingEnd.side);
  return Object.entries(sockets[side]).flatMap(([name, { title, type, many }]): SocketOption[] => {
    const socket = many && side === 'inputs' ? `${name}.${freeNumber(level.graph, id, name)}` : name;
    return fits(id, socket) ? [{ socket, title: title ?? (name === type ? socketTitle(type) : name) }] : [];
  });
}

/** The number after the highest in use. */
export function freeNumber({ edges }: Graph, node: string, input: string): number {
  const taken = Object.values(edges).flatMap(({ to }) =>
    to.node === node && to.input.startsWith(`${input}.`) ? [Number(to.input.slice(input.length + 1))] : [],
  );
  return Math.max(0, ...taken) + 1;
}

/** The socket that connects a new node of a type to a pending connection; undefined if none fits. */
export function socketFor(level: GraphLevel, type: NodeType, pendingEnd: PendingConnection): string | undefined {
  if (type.id === GROUP_INPUT || type.id === GROUP_OUTPUT) return undefined;
  return socketAmong(socketsOfType(type), typeAt(inferTypes(level, nodeLibrary), pendingEnd), pendingEnd.side);
}

/** As `socketFor`, for an instance of a group of the document. */
export function socketForGroup(level: GraphLevel, group: string, pendingEnd: PendingConnection): string | undefined {
  const sockets = socketsOf(level, { type: GROUP, params: { group } }, nodeLibrary);
  return sockets && socketAmong(sockets, typeAt(inferTypes(level, nodeLibrary), pendingEnd), pendingEnd.side);
}

function socketAmong(sockets: NodeSockets, pendingEnd: string, side: PendingConnection['side']): string | undefined {
  const entries = Object.entries(sockets[oppositeSide(side)]);
  const convert = (type: string) => (side === 'outputs' ? conversion(pendingEnd, type) : conversion(type, pendingEnd));
  // Prefers the same type to one that needs a conversion.
  const found = entries.find(([, { type }]) => type === pendingEnd) ?? entries.find(([, { type }]) => convert(type));
  if (!found) return undefined;
  return found[1].many && side === 'outputs' ? `${found[0]}.1` : found[0];
}
