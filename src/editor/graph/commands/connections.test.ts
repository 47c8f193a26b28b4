import { describe, expect, it } from 'vitest';
import { levelOf } from '../../../graph/analysis/sockets.ts';
import { edgeError, validateDocument } from '../../../graph/analysis/validate.ts';
import { edgeKey, type GraphDocument } from '../../../graph/document/document.ts';
import { applyCommand, type Command } from '../../../graph/edits/commands.ts';
import { groupCommand } from '../../../graph/edits/group.ts';
import { inEnglish } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { newProject } from '../../../nodes/project/projectCommands.ts';
import { NEW_SOCKET } from '../cards/cardModel.ts';
import { addableNodes } from '../search/addableNodes.ts';
import { connectionCheck, edgeBetween, type PendingConnection, socketFor, socketOptions } from './connections.ts';
import {
  addNodeCommand,
  changeSocketCommand,
  connectCommand,
  frameCommand,
  removeCommand,
  rerouteCommand,
} from './edits.ts';

const added = (document: GraphDocument, ...nodes: (readonly [id: string, type: string])[]): GraphDocument =>
  applyCommand(document, {
    kind: 'batch',
    commands: nodes.map(([node, type]): Command => ({ kind: 'add-node', node, type, at: [0, 0] })),
  }).document;
const project = added(
  newProject('a.usda'),
  ['box', 'box'],
  ['math', 'math'],
  ['bend', 'reroute'],
  ['switch', 'switch'],
);
const level = levelOf(project)!;
const run = (command: Command, document = project): GraphDocument => applyCommand(document, command).document;

describe('compatible ends of a pending connection', () => {
  it('are the sockets of all nodes that the engine accepts', () => {
    const ends: PendingConnection[] = Object.entries(project.nodes).flatMap(([node, { type }]) => [
      ...Object.keys(nodeLibrary[type]!.outputs).map(
        (socket): PendingConnection => ({ node, side: 'outputs', socket }),
      ),
      ...Object.keys(nodeLibrary[type]!.params).map((socket): PendingConnection => ({ node, side: 'inputs', socket })),
    ]);
    const odd = ends.flatMap((pendingEnd) => {
      const fits = connectionCheck(level, pendingEnd);
      return Object.entries(project.nodes).flatMap(([node, { type }]) => {
        const { inputs, outputs, params } = nodeLibrary[type]!;
        const names = pendingEnd.side === 'inputs' ? Object.keys(outputs) : [...Object.keys(params), ...single(inputs)];
        return names.flatMap((socket) => {
          const refusal = edgeError(project, edgeBetween(pendingEnd, node, socket), nodeLibrary);
          return fits(node, socket) === (refusal === undefined)
            ? []
            : [`${JSON.stringify(pendingEnd)} ${node}.${socket}`];
        });
      });
    });
    expect(odd).toEqual([]);
    expect(ends.length).toBeGreaterThan(30);
  });

  it('include the free socket of multi-inputs, and parameters', () => {
    const offers = socketOptions(level, { node: 'box', side: 'outputs', socket: 'geometry' }, 'scene');
    expect(offers.map(({ socket }) => socket)).toEqual(['geometry.2']);
    const numbers = socketOptions(level, { node: 'math', side: 'outputs', socket: 'number' }, 'box');
    expect(numbers.map(({ socket }) => socket)).toEqual(['width', 'height', 'depth']);
  });

  it('include new nodes that accept it, which are connected', () => {
    const pendingEnd: PendingConnection = { node: 'box', side: 'outputs', socket: 'geometry' };
    const types = addableNodes(level, pendingEnd).map(({ id }) => id);
    expect(types).toEqual(expect.arrayContaining(['transform', 'merge', 'scene', 'reroute']));
    expect(types).not.toContain('tone-map');
    for (const addition of addableNodes(level, pendingEnd)) {
      const { command } = addNodeCommand(level, addition, [0, 0], pendingEnd);
      const edges = Object.keys(run(command).edges).length;
      expect(edges, addition.id).toBe(Object.keys(project.edges).length + 1);
    }
    expect(socketFor(level, nodeLibrary.scene!, pendingEnd)).toBe('geometry.1');
  });
});

const single = (inputs: object): string[] =>
  Object.entries(inputs).flatMap(([name, socket]) => ('many' in socket ? [] : [name]));

describe('edits on the canvas', () => {
  it('a reroute does not change the data flow', () => {
    const edge = project.edges['console.scene']!;
    const { command, node } = rerouteCommand(level, edge, [100, 50]);
    const document = run(command);
    expect(document.edges['console.scene']?.from.node).toBe(node);
    expect(document.edges[edgeKey({ node, input: 'in' })]?.from).toEqual(edge.from);
    expect(
      validateDocument(document, nodeLibrary).filter(({ place }) => inEnglish(place).startsWith('console')),
    ).toEqual([]);
  });

  it('a node is in at most one frame, and empty frames are removed', () => {
    const first = run(frameCommand(level, ['box', 'math'], 'A').command);
    const second = run(frameCommand(levelOf(first)!, ['box'], 'B').command, first);
    expect(second.frames).toEqual({ frame: { title: 'A', nodes: ['math'] }, frame2: { title: 'B', nodes: ['box'] } });
    const third = run(frameCommand(levelOf(second)!, ['box', 'math'], 'C').command, second);
    expect(Object.values(third.frames)).toEqual([{ title: 'C', nodes: ['box', 'math'] }]);
  });

  it('removing nodes removes their edges', () => {
    const none = { nodes: ['console'], notes: [], frames: [], edges: ['output.image'] };
    expect(Object.keys(run(removeCommand(level, none)).edges)).toEqual(
      Object.keys(project.edges).filter((key) => !['console.scene', 'camera.relativity', 'output.image'].includes(key)),
    );
  });

  it('a group gets a socket by an edge to its add-socket handle, and loses it everywhere', () => {
    const { command, group } = groupCommand(project, { nodes: ['math'] }, '', nodeLibrary);
    const grouped = run(command);
    const inner = levelOf(grouped, group)!;
    const entry = Object.keys(inner.graph.nodes).find((id) => inner.graph.nodes[id]?.type === 'group-input')!;
    const edge = { from: { node: entry, output: NEW_SOCKET }, to: { node: 'math', input: 'a' } };
    const widened = run(connectCommand(inner, edge), grouped);
    expect(widened.groups[group]!.inputs).toEqual([{ name: 'a', type: 'number' }]);
    expect(widened.groups[group]!.edges['math.a']?.from).toEqual({ node: entry, output: 'a' });
    const fed = run(
      {
        kind: 'batch',
        commands: [
          { kind: 'add-node', node: 'number', type: 'number', at: [0, 0] },
          {
            kind: 'connect',
            edge: { from: { node: 'number', output: 'number' }, to: { node: 'group', input: 'a' } },
          },
        ],
      },
      widened,
    );
    const named = run(changeSocketCommand(levelOf(fed, group)!, 'inputs', 'a', 'Speed'), fed);
    expect(named.groups[group]!.inputs).toEqual([{ name: 'a', type: 'number', title: 'Speed' }]);
    const cut = run(changeSocketCommand(levelOf(named, group)!, 'inputs', 'a'), named);
    expect(cut.groups[group]!.inputs).toEqual([]);
    expect(cut.groups[group]!.edges).toEqual({});
    expect(cut.edges['group.a']).toBeUndefined();
  });

  it('a group is not offered within itself', () => {
    const { command, group } = groupCommand(project, { nodes: ['math'] }, '', nodeLibrary);
    const grouped = run(command);
    const ids = (inside?: string) => addableNodes(levelOf(grouped, inside)!).map(({ id }) => id);
    expect(ids()).toContain(`group:${group}`);
    expect(ids(group)).not.toContain(`group:${group}`);
    expect(ids()).not.toContain('group-input');
  });
});
