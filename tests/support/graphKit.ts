import fc from 'fast-check';
import { edgeError } from '../../src/graph/analysis/validate.ts';
import {
  type EventMark,
  emptyDocument,
  type GraphDocument,
  type GraphEdge,
  graphIn,
} from '../../src/graph/document/document.ts';
import { GROUP } from '../../src/graph/document/structuralTypes.ts';
import { applyCommand, type CanvasPoint, type Command, CommandError } from '../../src/graph/edits/commands.ts';
import { copyFragment, duplicateSelection, insideGroup, pasteFragment } from '../../src/graph/edits/fragment.ts';
import { groupCommand } from '../../src/graph/edits/group.ts';
import { ungroupCommand } from '../../src/graph/edits/ungroup.ts';
import type { NodeType } from '../../src/graph/nodeType.ts';
import { msg } from '../../src/messages/message.ts';

const base = { title: msg`toy`, help: msg`toy`, category: 'utility', params: {}, inputs: {}, outputs: {} } as const;
const number = { type: 'number' } as const;
const some = { type: 'number', optional: true } as const;
const any = { type: 'any', optional: true } as const;
const bias = { kind: 'number', title: 'bias', default: 0, min: -1e9, max: 1e9, step: 1 } as const;
const sumOf = (values: readonly unknown[]): number => values.reduce<number>((total, value) => total + Number(value), 0);
const passes: NodeType['evaluate'] = () => {
  throw new Error('flattening takes these out');
};

/** A node library on numbers with every kind of socket. */
export const toys = {
  value: {
    ...base,
    id: 'value',
    params: { value: { ...bias, default: 1 } },
    outputs: { number },
    evaluate: (_, { value }) => ({ number: value }),
  },
  sum: {
    ...base,
    id: 'sum',
    params: { bias },
    inputs: { a: some, b: some },
    outputs: { number },
    evaluate: ({ a = 0, b = 0 }, params) => ({ number: sumOf([a, b, params.bias]) }),
  },
  /** a + 2b + 3c …: the order matters. */
  weigh: {
    ...base,
    id: 'weigh',
    inputs: { items: { type: 'number', many: true, optional: true } },
    outputs: { number },
    evaluate: ({ items = [] }) => ({ number: sumOf((items as number[]).map((item, i) => item * (i + 1))) }),
  },
  pick: {
    ...base,
    id: 'pick',
    params: { second: { kind: 'boolean', title: 'second', default: false } },
    inputs: { a: any, b: any },
    outputs: { out: { type: 'any' } },
    needs: ({ second }) => [second ? 'b' : 'a'],
    evaluate: ({ a, b }, { second }) => ({ out: (second ? b : a) ?? 0 }),
  },
  words: { ...base, id: 'words', outputs: { text: { type: 'text' } }, evaluate: () => ({ text: 'words' }) },
  paint: { ...base, id: 'paint', outputs: { color: { type: 'color' } }, evaluate: () => ({ color: [1, 0, 0] }) },
  length: {
    ...base,
    id: 'length',
    inputs: { vector: { type: 'vector', optional: true } },
    outputs: { number },
    // An unconnected `pick` gives 0 to inputs of every type.
    evaluate: ({ vector = [0, 0, 0] }) => ({ number: Math.hypot(...[vector as number | number[]].flat()) }),
  },
  reroute: { ...base, id: 'reroute', inputs: { in: any }, outputs: { out: { type: 'any' } }, evaluate: passes },
  group: { ...base, id: 'group', params: { group: { kind: 'text', title: 'group', default: '' } }, evaluate: passes },
  'group-input': { ...base, id: 'group-input', evaluate: passes },
  'group-output': { ...base, id: 'group-output', evaluate: passes },
} as const satisfies Record<string, NodeType>;

const markNamed = (name: string): EventMark => ({
  name,
  time: 1,
  position: [0, 0, 0],
  properTime: 1,
  ownTime: 1,
  u: [0, 0, 0],
});

export const add = (node: string, type: string, at: CanvasPoint = [0, 0]): Command => ({
  kind: 'add-node',
  node,
  type,
  at,
});
export const set = (node: string, param: string, value?: number | string | boolean): Command => ({
  kind: 'set-param',
  node,
  param,
  ...(value === undefined ? {} : { value }),
});
/** `x.number` and `s.a` → an edge. */
export function edge(from: string, to: string): GraphEdge {
  const [source, target] = [from.split('.'), /^([^.]+)\.(.+)$/.exec(to)!];
  return { from: { node: source[0]!, output: source[1]! }, to: { node: target[1]!, input: target[2]! } };
}
export const connect = (from: string, to: string): Command => ({ kind: 'connect', edge: edge(from, to) });
export const edited = (document: GraphDocument, ...commands: readonly Command[]): GraphDocument =>
  applyCommand(document, { kind: 'batch', commands }).document;
export const build = (...commands: readonly Command[]): GraphDocument => edited(emptyDocument(), ...commands);

/** The random numbers from which an edit is made: its kind and operands. */
interface Seed {
  readonly op: number;
  readonly a: number;
  readonly b: number;
  readonly c: number;
}

const TYPES = ['value', 'sum', 'weigh', 'pick', 'words', 'length', 'reroute', 'value', 'sum'];
const INPUTS = ['a', 'b', 'bias', 'items.1', 'items.2', 'vector', 'in', 'value', 'second'];

/** A command that is valid for the document; undefined if there is none of its kind. */
export function commandFrom(document: GraphDocument, { op, a, b, c }: Seed): Command | undefined {
  const levels = [undefined, ...Object.keys(document.groups)];
  const group = levels[c % levels.length];
  const level = graphIn(document, group)!;
  const nodes = Object.keys(level.nodes);
  const at = (index: number): string => nodes[index % nodes.length]!;
  const here = (command: Command): Command => insideGroup(group, command);
  const chosen = [...new Set([at(a), at(b), at(a + b), at(c)])].filter((id) => id !== undefined);
  if (nodes.length < 3 || op < 12) {
    const free = Array.from({ length: 200 }, (_, i) => `n${i}`).find((id) => !Object.hasOwn(level.nodes, id))!;
    return here({ kind: 'add-node', node: free, type: TYPES[a % TYPES.length]!, at: [b, c] });
  }
  if (op < 32) {
    const [from, to] = [at(a), at(b)];
    const outputs = ['number', 'out', 'text'];
    const tried = INPUTS.flatMap((input) => outputs.map((output) => edge(`${from}.${output}`, `${to}.${input}`)));
    const fitting = tried.filter((candidate) => edgeError(document, candidate, toys, group) === undefined);
    return fitting.length === 0 ? undefined : here({ kind: 'connect', edge: fitting[c % fitting.length]! });
  }
  const kinds: (() => Command)[] = [
    () => here({ kind: 'remove-nodes', nodes: chosen.slice(0, 2) }),
    () => here({ kind: 'move-nodes', to: Object.fromEntries(chosen.map((id) => [id, [a, b]])) }),
    () => here({ kind: 'disconnect', to: Object.values(level.edges)[a % 7]?.to ?? { node: at(a), input: 'a' } }),
    () => here(set(at(a), 'value', b)),
    () => here(set(at(a), 'value')),
    () => here({ kind: 'rename', node: at(a), ...(b % 2 ? { title: `t${b}` } : {}) }),
    () => here({ kind: 'mute', nodes: chosen, muted: b % 2 === 0 }),
    () => here({ kind: 'collapse', nodes: chosen, collapsed: b % 2 === 0 }),
    () =>
      here({
        kind: 'set-note',
        note: `note${a % 3}`,
        ...(b % 3 ? { value: { text: `${b}`, at: [a, b], size: [100, 60] } } : {}),
      }),
    () =>
      here({
        kind: 'set-frame',
        frame: `frame${a % 3}`,
        ...(b % 3 ? { value: { title: `${b}`, nodes: chosen } } : {}),
      }),
    () => ({ kind: 'describe', what: a % 2 ? 'title' : 'lookFor', ...(b % 2 ? { value: `about ${b}` } : {}) }),
    () => ({ kind: 'set-marks', marks: [markNamed(`m${a}`), markNamed(`m${a + 1}`)].slice(0, b % 3) }),
    () => ({ kind: 'set-file', file: `f${a % 2}.usda`, ...(b % 2 ? { value: { size: b } } : {}) }),
    () => groupCommand(document, { nodes: chosen, group }, `g${a}`, toys).command,
    () => duplicateSelection(document, { nodes: chosen, group }).command,
    () =>
      pasteFragment(document, copyFragment(document, { nodes: chosen, group }), levels[b % levels.length], [a, b])
        .command,
    () => ungroupCommand(document, nodes.find((id) => level.nodes[id]!.type === GROUP) ?? at(a), group).command,
  ];
  return kinds[op % kinds.length]!();
}

export const seeds = (count: number): fc.Arbitrary<Seed[]> =>
  fc.array(fc.record({ op: fc.nat(59), a: fc.nat(99), b: fc.nat(99), c: fc.nat(99) }), {
    minLength: 5,
    maxLength: count,
  });

/** The command of a seed and the resulting document; undefined if it cannot be applied. */
export function tried(document: GraphDocument, seed: Seed): { command: Command; document: GraphDocument } | undefined {
  try {
    const command = commandFrom(document, seed);
    return command && { command, document: applyCommand(document, command).document };
  } catch (error) {
    if (error instanceof CommandError) return undefined;
    throw error;
  }
}

/** Documents as users make them: by commands, with valid edges. */
export const documents = (count: number): fc.Arbitrary<GraphDocument> =>
  seeds(count).map((list) =>
    list.reduce((document, seed) => tried(document, seed)?.document ?? document, emptyDocument()),
  );
