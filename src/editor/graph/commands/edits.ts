import { inferTypes } from '../../../graph/analysis/inferTypes.ts';
import { type GraphLevel, inputName } from '../../../graph/analysis/sockets.ts';
import {
  edgeKey,
  type GraphEdge,
  type GraphFrame,
  type GroupSocket,
  type NodeGroup,
  own,
} from '../../../graph/document/document.ts';
import { GROUP, GROUP_INPUT, REROUTE } from '../../../graph/document/structuralTypes.ts';
import type { CanvasPoint, Command } from '../../../graph/edits/commands.ts';
import { insideGroup } from '../../../graph/edits/fragment.ts';
import { FreshKeys } from '../../../graph/edits/freshKeys.ts';
import { ANY } from '../../../graph/nodeType.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import type { CanvasSelection } from '../canvas/canvasState.ts';
import { NEW_SOCKET } from '../cards/cardModel.ts';
import { edgeBetween, type PendingConnection } from './connections.ts';

/** Document commands of canvas operations, each for one level. */
const levelBatch = (level: GraphLevel, commands: readonly Command[]): Command =>
  insideGroup(level.group, { kind: 'batch', commands });

const connectEdge = (edge: GraphEdge): Command => ({ kind: 'connect', edge });

/** A kind of node that can be added: a type, or a group of the document. */
export interface AddableNode {
  readonly type: string;
  readonly group?: string;
  /** Socket that is connected to the pending connection. */
  readonly socket?: string;
}

/** Adds a node with its corner at `at`; also returns its id. */
export function addNodeCommand(
  level: GraphLevel,
  { type, group, socket }: AddableNode,
  at: CanvasPoint,
  pendingEnd?: PendingConnection,
) {
  const node = new FreshKeys(level.graph.nodes).next(type);
  const params = group === undefined ? {} : { params: { group } };
  const place: CanvasPoint = [Math.round(at[0]), Math.round(at[1])];
  const add: Command = { kind: 'add-node', node, type, at: place, ...params };
  const commands = [levelBatch(level, [add])];
  if (pendingEnd && socket !== undefined) commands.push(connectCommand(level, edgeBetween(pendingEnd, node, socket)));
  return { node, command: { kind: 'batch', commands } as const };
}

/** Adds an edge; one to a group's new-socket placeholder also creates the socket. */
export function connectCommand(level: GraphLevel, edge: GraphEdge): Command {
  const group = level.group === undefined ? undefined : own(level.document.groups, level.group);
  const enters = edge.from.output === NEW_SOCKET;
  if (!group || (!enters && edge.to.input !== NEW_SOCKET)) return levelBatch(level, [connectEdge(edge)]);
  const types = inferTypes(level, nodeLibrary);
  const wanted = enters ? inputName(edge.to.input).base : edge.from.output;
  const name = new FreshKeys(
    Object.fromEntries(group[enters ? 'inputs' : 'outputs'].map((each) => [each.name, 0])),
  ).next(wanted);
  const type = enters
    ? types.typeOf(edge.to.node, 'inputs', edge.to.input)
    : types.typeOf(edge.from.node, 'outputs', edge.from.output);
  const joined: GraphEdge = enters
    ? { from: { ...edge.from, output: name }, to: edge.to }
    : { from: edge.from, to: { ...edge.to, input: name } };
  const value = withSocket(group, enters, { name, type: type ?? ANY });
  const widened: Command = { kind: 'set-group', group: level.group!, value };
  return { kind: 'batch', commands: [widened, levelBatch(level, [connectEdge(joined)])] };
}

const withSocket = (group: NodeGroup, enters: boolean, socket: GroupSocket): NodeGroup =>
  enters ? { ...group, inputs: [...group.inputs, socket] } : { ...group, outputs: [...group.outputs, socket] };

/** Replaces an edge by its reconnected form. */
export const reconnectCommand = (level: GraphLevel, before: GraphEdge, edge: GraphEdge): Command => ({
  kind: 'batch',
  commands: [levelBatch(level, [{ kind: 'disconnect', to: before.to }]), connectCommand(level, edge)],
});

export function removeCommand(level: GraphLevel, { nodes, notes, frames, edges }: CanvasSelection): Command {
  return levelBatch(level, [
    ...edges.flatMap((key) => disconnectCommands(level, key)),
    ...frames.map((frame): Command => ({ kind: 'set-frame', frame })),
    ...notes.map((note): Command => ({ kind: 'set-note', note })),
    { kind: 'remove-nodes', nodes },
  ]);
}

const disconnectCommands = ({ graph }: GraphLevel, key: string): Command[] => {
  const edge = own(graph.edges, key);
  return edge ? [{ kind: 'disconnect', to: edge.to }] : [];
};

/** Inserts a reroute centered at `at`. */
export function rerouteCommand(level: GraphLevel, edge: GraphEdge, [x, y]: CanvasPoint) {
  const node = new FreshKeys(level.graph.nodes).next(REROUTE);
  const command = levelBatch(level, [
    { kind: 'add-node', node, type: REROUTE, at: [Math.round(x) - 9, Math.round(y) - 9] },
    connectEdge({ from: edge.from, to: { node, input: 'in' } }),
    connectEdge({ from: { node, output: 'out' }, to: edge.to }),
  ]);
  return { node, command };
}

/** Adds a frame around nodes, removing them from other frames. */
export function frameCommand(level: GraphLevel, nodes: readonly string[], title: string) {
  const frame = new FreshKeys(level.graph.frames).next('frame');
  const chosen = new Set(nodes);
  const others = Object.entries(level.graph.frames).flatMap(([key, held]): Command[] => {
    const left = held.nodes.filter((node) => !chosen.has(node));
    if (left.length === held.nodes.length) return [];
    const value: GraphFrame = { ...held, nodes: left };
    return [{ kind: 'set-frame', frame: key, ...(left.length > 0 && { value }) }];
  });
  return {
    frame,
    command: levelBatch(level, [...others, { kind: 'set-frame', frame, value: { title, nodes: [...nodes] } }]),
  };
}

const NOTE_SIZE: CanvasPoint = [220, 110];

export function noteCommand(level: GraphLevel, at: CanvasPoint) {
  const note = new FreshKeys(level.graph.notes).next('note');
  const value = { text: '', at: [Math.round(at[0]), Math.round(at[1])] as const, size: NOTE_SIZE };
  return { note, command: levelBatch(level, [{ kind: 'set-note', note, value }]) };
}

/** Moves nodes and notes. */
export function moveItemsCommand(
  level: GraphLevel,
  nodes: Readonly<Record<string, CanvasPoint>>,
  notes: Readonly<Record<string, CanvasPoint>> = {},
): Command {
  return levelBatch(level, [
    { kind: 'move-nodes', to: nodes },
    ...Object.entries(notes).flatMap(([note, at]): Command[] => {
      const held = own(level.graph.notes, note);
      return held ? [{ kind: 'set-note', note, value: { ...held, at } }] : [];
    }),
  ]);
}

/** Renames a group's socket; without a name removes it with its edges, in every instance of the group. */
export function changeSocketCommand(
  level: GraphLevel,
  side: 'inputs' | 'outputs',
  name: string,
  title?: string,
): Command {
  const key = level.group!;
  const group = level.document.groups[key]!;
  if (title !== undefined) {
    const sockets = group[side].map((socket) => (socket.name === name ? { ...socket, title } : socket));
    return { kind: 'set-group', group: key, value: { ...group, [side]: sockets } };
  }
  const carrier = side === 'inputs' ? GROUP_INPUT : 'group-output';
  const edges = Object.entries(group.edges).filter(([, { from, to }]) => {
    const [node, socket] = side === 'inputs' ? [from.node, from.output] : [to.node, to.input];
    return group.nodes[node]?.type !== carrier || socket !== name;
  });
  const sockets = group[side].filter((socket) => socket.name !== name);
  const value: NodeGroup = { ...group, edges: Object.fromEntries(edges), [side]: sockets };
  return {
    kind: 'batch',
    commands: [{ kind: 'set-group', group: key, value }, ...disconnectOuterEdges(level, side, name)],
  };
}

function disconnectOuterEdges({ document, group }: GraphLevel, side: 'inputs' | 'outputs', name: string): Command[] {
  const levels = [[undefined, document] as const, ...Object.entries(document.groups)];
  return levels.flatMap(([key, graph]) =>
    Object.values(graph.edges).flatMap(({ from, to }): Command[] => {
      const [id, socket] = side === 'inputs' ? [to.node, to.input] : [from.node, from.output];
      const node = own(graph.nodes, id);
      if (node?.type !== GROUP || node.params.group !== group || socket !== name) return [];
      return [insideGroup(key, { kind: 'disconnect', to })];
    }),
  );
}

/** Whether the document already has the edge. */
export const hasEdge = ({ graph }: GraphLevel, edge: GraphEdge): boolean => {
  const held = own(graph.edges, edgeKey(edge.to));
  return held !== undefined && held.from.node === edge.from.node && held.from.output === edge.from.output;
};
