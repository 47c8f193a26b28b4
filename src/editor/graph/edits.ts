import type { Command, Point } from '../../graph/commands.ts';
import { edgeKey, type Frame, type GraphEdge, type Group, type GroupSocket, own } from '../../graph/document.ts';
import { inside } from '../../graph/edits/fragment.ts';
import { FreshKeys } from '../../graph/edits/fresh.ts';
import { typesIn } from '../../graph/infer.ts';
import { ANY } from '../../graph/nodeType.ts';
import { inputName, type Level } from '../../graph/sockets.ts';
import { GROUP, GROUP_INPUT, REROUTE } from '../../graph/structure.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import type { Chosen } from './canvas.ts';
import { NEW_SOCKET } from './face.ts';
import { edgeTo, type Loose } from './fit.ts';

/** Commands for what is done on the canvas, each for the level that it is done in. */
const batch = (level: Level, commands: readonly Command[]): Command => inside(level.group, { kind: 'batch', commands });

const connect = (edge: GraphEdge): Command => ({ kind: 'connect', edge });

/** A kind of node that can be added: a type, or one of the document's groups. */
export interface Addition {
  readonly type: string;
  readonly group?: string;
  /** Connected to the loose end by this socket. */
  readonly socket?: string;
}

/** A new node with its corner at `at`, and what it is called. */
export function adding(level: Level, { type, group, socket }: Addition, at: Point, loose?: Loose) {
  const node = new FreshKeys(level.graph.nodes).take(type);
  const params = group === undefined ? {} : { params: { group } };
  const place: Point = [Math.round(at[0]), Math.round(at[1])];
  const add: Command = { kind: 'add-node', node, type, at: place, ...params };
  const commands = [batch(level, [add])];
  if (loose && socket !== undefined) commands.push(connecting(level, edgeTo(loose, node, socket)));
  return { node, command: { kind: 'batch', commands } as const };
}

/** An edge; one that ends at a group's place for new sockets makes one there. */
export function connecting(level: Level, edge: GraphEdge): Command {
  const group = level.group === undefined ? undefined : own(level.document.groups, level.group);
  const enters = edge.from.output === NEW_SOCKET;
  if (!group || (!enters && edge.to.input !== NEW_SOCKET)) return batch(level, [connect(edge)]);
  const types = typesIn(level, nodeLibrary);
  const wanted = enters ? inputName(edge.to.input).base : edge.from.output;
  const name = new FreshKeys(
    Object.fromEntries(group[enters ? 'inputs' : 'outputs'].map((each) => [each.name, 0])),
  ).take(wanted);
  const type = enters
    ? types.typeOf(edge.to.node, 'inputs', edge.to.input)
    : types.typeOf(edge.from.node, 'outputs', edge.from.output);
  const joined: GraphEdge = enters
    ? { from: { ...edge.from, output: name }, to: edge.to }
    : { from: edge.from, to: { ...edge.to, input: name } };
  const value = withSocket(group, enters, { name, type: type ?? ANY });
  const widened: Command = { kind: 'set-group', group: level.group!, value };
  return { kind: 'batch', commands: [widened, batch(level, [connect(joined)])] };
}

const withSocket = (group: Group, enters: boolean, socket: GroupSocket): Group =>
  enters ? { ...group, inputs: [...group.inputs, socket] } : { ...group, outputs: [...group.outputs, socket] };

/** An edge drawn elsewhere: the old one goes. */
export const reconnecting = (level: Level, before: GraphEdge, edge: GraphEdge): Command => ({
  kind: 'batch',
  commands: [batch(level, [{ kind: 'disconnect', to: before.to }]), connecting(level, edge)],
});

export function removing(level: Level, { nodes, notes, frames, edges }: Chosen): Command {
  return batch(level, [
    ...edges.flatMap((key) => disconnecting(level, key)),
    ...frames.map((frame): Command => ({ kind: 'set-frame', frame })),
    ...notes.map((note): Command => ({ kind: 'set-note', note })),
    { kind: 'remove-nodes', nodes },
  ]);
}

const disconnecting = ({ graph }: Level, key: string): Command[] => {
  const edge = own(graph.edges, key);
  return edge ? [{ kind: 'disconnect', to: edge.to }] : [];
};

/** A bend in an edge, with its middle at `at`. */
export function bending(level: Level, edge: GraphEdge, [x, y]: Point) {
  const node = new FreshKeys(level.graph.nodes).take(REROUTE);
  const command = batch(level, [
    { kind: 'add-node', node, type: REROUTE, at: [Math.round(x) - 9, Math.round(y) - 9] },
    connect({ from: edge.from, to: { node, input: 'in' } }),
    connect({ from: { node, output: 'out' }, to: edge.to }),
  ]);
  return { node, command };
}

/** A frame around nodes; from other frames they are taken out. */
export function framing(level: Level, nodes: readonly string[], title: string) {
  const frame = new FreshKeys(level.graph.frames).take('frame');
  const chosen = new Set(nodes);
  const others = Object.entries(level.graph.frames).flatMap(([key, held]): Command[] => {
    const left = held.nodes.filter((node) => !chosen.has(node));
    if (left.length === held.nodes.length) return [];
    const value: Frame = { ...held, nodes: left };
    return [{ kind: 'set-frame', frame: key, ...(left.length > 0 && { value }) }];
  });
  return {
    frame,
    command: batch(level, [...others, { kind: 'set-frame', frame, value: { title, nodes: [...nodes] } }]),
  };
}

const NOTE_SIZE: Point = [220, 110];

export function noting(level: Level, at: Point) {
  const note = new FreshKeys(level.graph.notes).take('note');
  const value = { text: '', at: [Math.round(at[0]), Math.round(at[1])] as const, size: NOTE_SIZE };
  return { note, command: batch(level, [{ kind: 'set-note', note, value }]) };
}

/** Nodes and notes moved to places. */
export function moving(
  level: Level,
  nodes: Readonly<Record<string, Point>>,
  notes: Readonly<Record<string, Point>> = {},
): Command {
  return batch(level, [
    { kind: 'move-nodes', to: nodes },
    ...Object.entries(notes).flatMap(([note, at]): Command[] => {
      const held = own(level.graph.notes, note);
      return held ? [{ kind: 'set-note', note, value: { ...held, at } }] : [];
    }),
  ]);
}

/** A group's socket under another name, or without one taken away with its edges, wherever the group is used. */
export function changingSocket(level: Level, side: 'inputs' | 'outputs', name: string, title?: string): Command {
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
  const value: Group = { ...group, edges: Object.fromEntries(edges), [side]: sockets };
  return { kind: 'batch', commands: [{ kind: 'set-group', group: key, value }, ...outerCuts(level, side, name)] };
}

function outerCuts({ document, group }: Level, side: 'inputs' | 'outputs', name: string): Command[] {
  const levels = [[undefined, document] as const, ...Object.entries(document.groups)];
  return levels.flatMap(([key, graph]) =>
    Object.values(graph.edges).flatMap(({ from, to }): Command[] => {
      const [id, socket] = side === 'inputs' ? [to.node, to.input] : [from.node, from.output];
      const node = own(graph.nodes, id);
      if (node?.type !== GROUP || node.params.group !== group || socket !== name) return [];
      return [inside(key, { kind: 'disconnect', to })];
    }),
  );
}

/** Whether the document has the edge, so that nothing need be done. */
export const isThere = ({ graph }: Level, edge: GraphEdge): boolean => {
  const held = own(graph.edges, edgeKey(edge.to));
  return held !== undefined && held.from.node === edge.from.node && held.from.output === edge.from.output;
};
