import { describe, expect, it } from 'vitest';
import { english, saying } from '../../../../tests/support/inWords.ts';
import { inferTypes } from '../../../graph/analysis/inferTypes.ts';
import { levelOf } from '../../../graph/analysis/sockets.ts';
import type { GraphDocument } from '../../../graph/document/document.ts';
import { applyCommand, type Command } from '../../../graph/edits/commands.ts';
import { Evaluator } from '../../../graph/evaluation/evaluator.ts';
import type { NodeResult } from '../../../graph/evaluation/resultCache.ts';
import { inEnglish, msg } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { newProject } from '../../../nodes/project/projectCommands.ts';
import { workerServices } from '../../../nodes/services.ts';
import { EMPTY_SELECTION } from '../canvas/canvasState.ts';
import { ElementCache, type FlowNode, flowEdges, flowNodes, type WireEdge } from '../canvas/flowElements.ts';
import { cardSize, socketPositions } from './cardGeometry.ts';
import { type CardModel, cardModel, connectedSockets } from './cardModel.ts';
import { problemsByNode } from './problems.ts';

const run = (document: GraphDocument, ...commands: Command[]): GraphDocument =>
  applyCommand(document, { kind: 'batch', commands }).document;
const add = (node: string, type: string, params = {}): Command => ({
  kind: 'add-node',
  node,
  type,
  at: [0, 0],
  params,
});
const join = (node: string, output: string, to: string, input: string): Command => ({
  kind: 'connect',
  edge: { from: { node, output }, to: { node: to, input } },
});

const document = run(
  newProject(''),
  add('box', 'box', { name: 'A', width: 2, height: 3, depth: 4 }),
  add('number', 'number', { number: 0.5 }),
  add('math', 'math', { operation: 'multiply', a: 3 }),
  add('lost', 'no-such-type'),
  { kind: 'disconnect', to: { node: 'scene', input: 'geometry.1' } },
  join('box', 'geometry', 'scene', 'geometry.1'),
  join('number', 'number', 'box', 'width'),
  join('number', 'number', 'math', 'b'),
  join('math', 'number', 'console', 'maxSpeed'),
  join('box', 'geometry', 'lost', 'anything'),
);
const readScene = () => Promise.reject(new Error('there are no files'));

async function facesOf(held: GraphDocument): Promise<ReadonlyMap<string, CardModel>> {
  const { results } = await new Evaluator(nodeLibrary).evaluate(held, ['output', 'scene'], {
    ...workerServices,
    readScene,
  });
  const level = levelOf(held)!;
  const problems = problemsByNode(results);
  const around = {
    level,
    types: inferTypes(level, nodeLibrary),
    edges: connectedSockets(held.edges),
    resultOf: (node: string) => results.get(node),
    problemOf: (node: string) => problems.get(node),
    pictures: true,
  };
  return new Map(Object.entries(held.nodes).map(([id, node]) => [id, cardModel(id, node, around)]));
}

const inputs = (card: CardModel) => card.rows.flatMap(({ input }) => input?.name ?? []);

describe('the card of a node', () => {
  it('has its inputs, multi-inputs with one more free socket, and the parameters that are set or driven', async () => {
    const cards = await facesOf(document);
    expect(inputs(cards.get('scene')!)).toEqual(['geometry.1', 'geometry.2', 'lights.1', 'observer', 'time']);
    expect(inputs(cards.get('box')!)).toEqual(['name', 'width', 'height', 'depth']);
    expect(cards.get('box')!.rows[2]).toMatchObject({ title: msg`Width (x)`, input: { connected: true } });
    expect(cards.get('box')!.rows[2]).not.toHaveProperty('value');
    expect(inputs(cards.get('console')!)).toEqual(['scene', 'maxSpeed']);
    expect(inputs(cards.get('math')!)).toEqual(['operation', 'a', 'b']);
    expect(inputs(cards.get('lost')!)).toEqual(['anything']);
  });

  it('has its results', async () => {
    const cards = await facesOf(document);
    expect(cards.get('box')!.preview).toEqual({
      kind: 'text',
      text: saying(/^Objects: 1 · vertices: 24$/),
    });
    // 3 × 0.5 c is above the observer's speed limit.
    expect(cards.get('math')!.preview).toEqual({ kind: 'text', text: '1.50000' });
    expect(english(cards.get('console')!.problem?.message)).toContain('1.5 is outside');
    expect(cards.get('camera')!.blocked).toBe(true);
    expect(cards.get('number')!.hasPreview).toBe(false);
  });

  it('of a group has the problems of its inner nodes', () => {
    const problem = { severity: 'error', code: 'x', place: 'a/b/c', message: msg`no` } as const;
    const found = problemsByNode(new Map([['a/b/c', { status: 'failed', problem }]]));
    expect([...found.keys()].sort()).toEqual(['a', 'a/b', 'a/b/c']);
  });

  it('has the first warning about its node, not those about other nodes or files; errors come first', () => {
    const note = (severity: 'warning' | 'info', place: string) => ({ severity, code: 'x', place, message: msg`no` });
    const scene = {
      diagnostics: [note('warning', 'a.usda'), note('info', 'g/run.step'), note('warning', 'g/run.method')],
    };
    const problem = { severity: 'error', code: 'x', place: 'g/b', message: msg`no` } as const;
    const outputs = { geometry: { scene }, books: undefined };
    const found = problemsByNode(
      new Map<string, NodeResult>([
        ['g/run', { status: 'done', outputs }],
        ['scene', { status: 'done', outputs }],
        ['g/b', { status: 'failed', problem }],
      ]),
    );
    expect(found.get('g/run')).toMatchObject({ severity: 'warning', place: 'g/run.method' });
    expect(found.get('g')).toBe(problem);
    expect(found.has('scene')).toBe(false);
  });

  it('has every socket on its border, within its height, separate from the others', async () => {
    for (const card of (await facesOf(document)).values()) {
      const [width, height] = cardSize(card);
      const places = socketPositions(card);
      expect(new Set(places.map(({ at }) => String(at))).size).toBe(places.length);
      for (const { at, side } of places) {
        expect(at[0]).toBe(side === 'inputs' ? 0 : width);
        expect(at[1]).toBeGreaterThan(0);
        expect(at[1]).toBeLessThan(height);
      }
    }
  });
});

it('unchanged cards keep their identity, so that they are not rendered again', async () => {
  const [nodes, edges] = [new ElementCache<FlowNode>(), new ElementCache<WireEdge>()];
  const shown = async (held: GraphDocument) => {
    const level = levelOf(held)!;
    const input = {
      level,
      cards: await facesOf(held),
      places: held.layout,
      notes: {},
      selection: EMPTY_SELECTION,
      overhangs: new Map(),
    };
    return {
      nodes: flowNodes({ ...input, nameOf: ({ title }) => inEnglish(title) }, nodes),
      edges: flowEdges(level, inferTypes(level, nodeLibrary), EMPTY_SELECTION, inEnglish, edges),
    };
  };
  const before = await shown(document);
  const after = await shown(run(document, { kind: 'move-nodes', to: { box: [50, 60] } }));
  const changed = after.nodes.filter((node, i) => node !== before.nodes[i]);
  expect(changed.map(({ id, position }) => [id, position])).toEqual([['box', { x: 50, y: 60 }]]);
  expect(after.edges.every((edge, i) => edge === before.edges[i])).toBe(true);
});
