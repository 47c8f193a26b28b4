import { describe, expect, it } from 'vitest';
import { add, build, connect, edge, edited, set, toys } from '../../../tests/support/graphKit.ts';
import { english, saying } from '../../../tests/support/inWords.ts';
import { inEnglish } from '../../messages/message.ts';
import { emptyGraph, type GraphDocument, type NodeGroup } from '../document/document.ts';
import { findFault } from '../document/integrity.ts';
import type { Command } from '../edits/commands.ts';
import { groupCommand } from '../edits/group.ts';
import { Evaluator } from '../evaluation/evaluator.ts';
import { flatten } from './flatten.ts';
import { inferTypes } from './inferTypes.ts';
import { levelOf } from './sockets.ts';
import { edgeError, validateDocument } from './validate.ts';

const sourcesOf = (document: GraphDocument, node: string) =>
  Object.fromEntries(
    [...flatten(document, toys).nodes.get(node)!.inputs].map(([input, sources]) => [
      input,
      sources.map((source) => (source.kind === 'output' ? `${source.node}.${source.output}` : inEnglish(source.why))),
    ]),
  );
const evaluate = async (document: GraphDocument, target = 'out') =>
  (await new Evaluator(toys).evaluate(document, target, {})).target;
const number = async (document: GraphDocument, target?: string) => {
  const result = await evaluate(document, target);
  return result.status === 'done' ? result.outputs.number : result;
};
const codes = (document: GraphDocument) =>
  validateDocument(document, toys).map(({ code, place }) => `${code} ${inEnglish(place)}`);
const mute = (...nodes: string[]): Command => ({ kind: 'mute', nodes, muted: true });
const putGroup = (group: string, value: NodeGroup): Command => ({ kind: 'set-group', group, value });
const emptyGroup: NodeGroup = { title: '', ...emptyGraph(), inputs: [], outputs: [] };

describe('a parameter', () => {
  const driven = build(add('x', 'value'), add('s', 'sum'), connect('x.number', 's.bias'), set('x', 'value', 4));

  it('is driven by an edge', async () => {
    expect(await number(driven, 's')).toBe(4);
    expect(codes(driven)).toEqual([]);
  });

  it('of type boolean is true for nonzero numbers', async () => {
    const document = build(
      add('x', 'value'),
      add('p', 'pick'),
      add('b', 'value'),
      connect('x.number', 'p.second'),
      connect('b.number', 'p.b'),
    );
    const picked = async (value: number) => {
      const result = await evaluate(edited(document, set('x', 'value', value)), 'p');
      return result.status === 'done' ? result.outputs.out : result;
    };
    expect([await picked(0), await picked(-2)]).toEqual([0, 1]);
  });

  it('rejects values out of range or of another type, at its node', async () => {
    const far = edited(
      driven,
      set('x', 'value', 1e9),
      add('y', 'sum'),
      set('y', 'bias', 1e9),
      connect('x.number', 'y.a'),
      connect('y.number', 's.bias'),
    );
    expect(await evaluate(far, 's')).toMatchObject({
      problem: { code: 'graph.param', place: 's.bias', message: saying('2000000000 is outside') },
    });
    expect(english(edgeError(edited(driven, add('t', 'words')), edge('t.text', 's.bias'), toys))).toBe(
      'text (t.text) does not fit number (s.bias)',
    );
  });

  it('with an invalid value has its default as remedy', async () => {
    const document = build(add('x', 'value'), set('x', 'value', 'five'));
    expect(await evaluate(document, 'x')).toMatchObject({
      problem: { code: 'graph.param', place: 'x.value', remedy: { node: 'x', param: 'value', value: 1 } },
    });
  });
});

describe('a multi-input', () => {
  it('takes its edges in the order of their numbers, with gaps', async () => {
    const document = build(
      add('w', 'weigh'),
      ...[10, 2, 1].flatMap((n) => [
        add(`v${n}`, 'value'),
        set(`v${n}`, 'value', n),
        connect(`v${n}.number`, `w.items.${n}`),
      ]),
    );
    expect(sourcesOf(document, 'w')).toEqual({ items: ['v1.number', 'v2.number', 'v10.number'] });
    expect(await number(document, 'w')).toBe(1 + 2 * 2 + 3 * 10);
    expect(codes(document)).toEqual([]);
  });

  it('requires a number; other inputs must not have one', () => {
    const document = build(add('w', 'weigh'), add('v', 'value'), add('s', 'sum'));
    expect(english(edgeError(document, edge('v.number', 'w.items'), toys))).toMatch(/no input "items"/);
    expect(english(edgeError(document, edge('v.number', 's.a.1'), toys))).toMatch(/no input "a.1"/);
    expect(english(edgeError(document, edge('v.number', 'w.items.1'), toys))).toBeUndefined();
  });
});

describe('a generic socket', () => {
  const two = build(
    add('p', 'pick'),
    add('q', 'pick'),
    add('r', 'reroute'),
    connect('p.out', 'r.in'),
    connect('r.out', 'q.a'),
    add('v', 'value'),
    add('t', 'words'),
  );
  const typeOf = (document: GraphDocument, node: string, side: 'inputs' | 'outputs', socket: string) =>
    inferTypes(levelOf(document)!, toys).typeOf(node, side, socket);

  it('has the type of the connected socket, through any number of generic ones', () => {
    expect(typeOf(two, 'q', 'outputs', 'out')).toBe('any');
    const told = edited(two, connect('v.number', 'p.b'));
    expect([typeOf(told, 'q', 'outputs', 'out'), typeOf(told, 'p', 'inputs', 'a')]).toEqual(['number', 'number']);
    const wanted = edited(two, add('l', 'length'), connect('q.out', 'l.vector'));
    expect(typeOf(wanted, 'p', 'inputs', 'a')).toBe('vector');
    expect(english(edgeError(wanted, edge('v.number', 'p.a'), toys))).toBeUndefined();
  });

  it('rejects a second type, and reports both ends', () => {
    const told = edited(two, connect('v.number', 'p.b'));
    expect(english(edgeError(told, edge('t.text', 'q.b'), toys))).toBe('text (t.text) does not fit number (v.number)');
    const wanted = edited(two, add('s', 'sum'), connect('q.out', 's.a'));
    expect(english(edgeError(wanted, edge('t.text', 'p.b'), toys))).toBe('text (t.text) does not fit number (s.a)');
    expect(codes(edited(wanted, connect('t.text', 'p.b')))).toEqual(['graph.edge s']);
  });

  it('has the common type of all its inputs, in any order of connection', () => {
    const base = edited(two, add('k', 'paint'), add('l', 'length'), add('s', 'sum'));
    for (const links of [
      ['v.number>p.a', 'k.color>q.b'],
      ['k.color>q.b', 'v.number>p.a'],
    ]) {
      const joined = edited(base, ...links.map((link) => connect(...(link.split('>') as [string, string]))));
      expect(codes(joined)).toEqual([]);
      expect(typeOf(joined, 'q', 'outputs', 'out')).toBe('color');
      expect(english(edgeError(joined, edge('q.out', 'l.vector'), toys))).toBeUndefined();
      expect(english(edgeError(joined, edge('q.out', 's.a'), toys))).toBe('color (k.color) does not fit number (s.a)');
    }
    for (const sinks of [
      ['l.vector', 's.a'],
      ['s.a', 'l.vector'],
    ])
      expect(codes(edited(base, ...sinks.map((sink) => connect('q.out', sink))))).toEqual([]);
  });

  it('evaluates only the needed branch', async () => {
    const document = build(
      add('p', 'pick'),
      add('v', 'value'),
      add('bad', 'value'),
      set('bad', 'value', 'x'),
      connect('v.number', 'p.a'),
      connect('bad.number', 'p.b'),
    );
    const { results, target } = await new Evaluator(toys).evaluate(document, 'p', {});
    expect(target).toEqual({ status: 'done', outputs: { out: 1 } });
    expect([...results.keys()].sort()).toEqual(['p', 'v']);
    expect(await evaluate(edited(document, set('p', 'second', true)), 'p')).toEqual({ status: 'blocked', by: 'bad' });
  });

  it('a number is converted to a vector where required, also through a switch', async () => {
    const document = build(
      add('v', 'value'),
      set('v', 'value', 2),
      add('p', 'pick'),
      add('l', 'length'),
      connect('v.number', 'p.a'),
      connect('p.out', 'l.vector'),
    );
    expect(await number(document, 'l')).toBeCloseTo(2 * Math.sqrt(3), 12);
    const odd = edited(document, add('t', 'words'), connect('t.text', 'p.a'));
    expect(await evaluate(odd, 'l')).toMatchObject({
      problem: { code: 'graph.edge', place: 'l', message: saying('text (p.out) does not fit vector') },
    });
  });
});

describe('muting', () => {
  const chain = build(
    add('x', 'value'),
    add('t', 'words'),
    add('s', 'sum'),
    add('out', 'sum'),
    set('s', 'bias', 100),
    connect('x.number', 's.b'),
    connect('s.number', 'out.a'),
  );

  it('passes on the first connected input of the type', async () => {
    expect(await number(chain)).toBe(101);
    expect(await number(edited(chain, mute('s')))).toBe(1);
    expect(sourcesOf(edited(chain, mute('s')), 'out')).toEqual({ a: ['x.number'] });
  });

  it('with nothing to pass on is reported where the value is missing', async () => {
    const muted = edited(chain, mute('s', 'x'), add('l', 'weigh'), connect('x.number', 'l.items.1'));
    expect(await number(muted)).toBe(0);
    expect(sourcesOf(muted, 'out').a).toEqual(['x is muted and has no number to pass on; unmute it']);
  });
});

describe('a group', () => {
  const grouped = () => {
    const document = build(
      add('x', 'value'),
      add('y', 'value'),
      add('s', 'sum'),
      add('out', 'sum'),
      set('y', 'value', 7),
      connect('x.number', 's.a'),
      connect('s.number', 'out.a'),
    );
    return edited(document, groupCommand(document, { nodes: ['s'] }, 'g', toys).command);
  };

  it('is instantiated once per node that uses it', async () => {
    const document = edited(
      grouped(),
      { kind: 'add-node', node: 'again', type: 'group', at: [0, 0], params: { group: 'group' } },
      connect('y.number', 'again.a'),
      connect('again.number', 'out.b'),
    );
    expect([...flatten(document, toys).nodes.keys()].sort()).toEqual(['again/s', 'group/s', 'out', 'x', 'y']);
    expect(await number(document)).toBe(8);
    expect(codes(document)).toEqual([]);
  });

  it('displays the value of its first output, and errors at its inner nodes', async () => {
    expect(await evaluate(grouped(), 'group')).toEqual({ status: 'done', outputs: { number: 1 } });
    const wrong = edited(grouped(), { kind: 'inside', group: 'group', command: set('s', 'bias', 'x') });
    const { target, results } = await new Evaluator(toys).evaluate(wrong, 'out', {});
    expect(target).toEqual({ status: 'blocked', by: 'group/s' });
    expect(results.get('group/s')).toMatchObject({ problem: { place: 'group/s.bias', remedy: { node: 'group/s' } } });
  });

  it('without definition, output or an edge to it is reported', async () => {
    const lost = edited(grouped(), { kind: 'set-group', group: 'group' });
    expect(codes(lost)).toContain('graph.group group');
    expect(sourcesOf(lost, 'out')).toEqual({ a: ['there is no group "group"'] });
    const inner = (command: Command): GraphDocument => edited(grouped(), { kind: 'inside', group: 'group', command });
    expect(sourcesOf(inner({ kind: 'remove-nodes', nodes: ['output'] }), 'out').a).toEqual([
      'the group group has no group output',
    ]);
    expect(sourcesOf(inner({ kind: 'remove-nodes', nodes: ['s'] }), 'out').a).toEqual([
      'in the group group nothing is connected to number',
    ]);
  });

  it('with generic sockets takes its types from inside and outside', () => {
    const document = build(add('r', 'reroute'), add('v', 'value'), add('out', 'sum'), add('t', 'words'));
    const group = edited(document, groupCommand(document, { nodes: ['r'] }, 'g', toys).command);
    const through = edited(
      group,
      putGroup('group', {
        ...group.groups.group!,
        inputs: [{ name: 'in', type: 'any' }],
        outputs: [{ name: 'out', type: 'any' }],
      }),
      {
        kind: 'inside',
        group: 'group',
        command: { kind: 'batch', commands: [connect('input.in', 'r.in'), connect('r.out', 'output.out')] },
      },
      connect('v.number', 'group.in'),
    );
    expect(english(edgeError(through, edge('group.out', 'out.a'), toys))).toBeUndefined();
    expect(codes(edited(through, connect('group.out', 'out.a')))).toEqual([]);
    const fixed = edited(through, {
      kind: 'inside',
      group: 'group',
      command: { kind: 'batch', commands: [add('s', 'sum'), connect('input.in', 's.a')] },
    });
    expect(english(edgeError(fixed, edge('t.text', 'group.in'), toys))).toBe(
      'text (t.text) does not fit number (group.in)',
    );
  });

  it('must not contain itself, nor expand to more nodes than a project may have', () => {
    const use = (group: string) => ({ type: 'group', params: { group } });
    const doubling = (depth: number): GraphDocument => {
      const document = structuredClone(build(add('top', 'group'), set('top', 'group', 'g0')));
      for (let i = 0; i < depth; i++)
        document.groups[`g${i}`] = {
          ...emptyGroup,
          nodes: i === depth - 1 ? { v: use('none') } : { a: use(`g${i + 1}`), b: use(`g${i + 1}`) },
        };
      return document;
    };
    expect(english(findFault(doubling(16)))).toBeUndefined();
    expect(() => flatten(doubling(16), toys)).toThrow(/opened out they make more than 10000 nodes/);
    expect(codes(doubling(16))).toEqual(['graph.document the project']);
    expect(english(findFault(doubling(18)))).toMatch(/more than 16 deep/);
    const circle = doubling(3);
    circle.groups.g2!.nodes.v!.params.group = 'g0';
    expect(english(findFault(circle))).toMatch(/holds itself: g0 → g1 → g2 → g0/);
    expect(() => flatten(circle, toys)).toThrow();
    expect(english(edgeError(circle, edge('top.x', 'top.y'), toys))).toMatch(/no output/);
  });
});

describe('cycles', () => {
  it('of nodes, reroutes and muted nodes are reported', async () => {
    const ring = build(
      add('a', 'sum'),
      add('b', 'sum'),
      add('out', 'sum'),
      connect('a.number', 'b.a'),
      connect('b.number', 'a.a'),
      connect('b.number', 'out.a'),
    );
    expect(codes(ring)).toEqual(['graph.cycle a', 'graph.cycle b']);
    expect(await evaluate(ring)).toEqual({ status: 'blocked', by: 'b' });
    const bends = build(
      add('r', 'reroute'),
      add('q', 'reroute'),
      add('out', 'sum'),
      connect('r.out', 'q.in'),
      connect('q.out', 'r.in'),
      connect('q.out', 'out.a'),
    );
    expect(sourcesOf(bends, 'out').a).toEqual([expect.stringMatching(/feeds itself/)]);
    expect(await evaluate(edited(ring, mute('a', 'b')))).toMatchObject({ status: 'done' });
  });
});

describe('long chains', () => {
  const CHAIN = 9_990;
  const chain = (type: string, input: string, output: string): GraphDocument => {
    const document = structuredClone(build(add('v', 'value'), add('out', 'sum')));
    for (let i = 0; i < CHAIN; i++) {
      document.nodes[`n${i}`] = { type, params: {} };
      const link = edge(i === 0 ? 'v.number' : `n${i - 1}.${output}`, `n${i}.${input}`);
      document.edges[`n${i}.${input}`] = link;
    }
    document.edges['out.a'] = edge(`n${CHAIN - 1}.${output}`, 'out.a');
    return document;
  };

  it.each([
    ['sum', 'a', 'number'],
    ['reroute', 'in', 'out'],
    ['pick', 'a', 'out'],
  ])('of %s are evaluated without stack overflow', async (type, input, output) => {
    const document = chain(type, input, output);
    expect(validateDocument(document, toys)).toEqual([]);
    expect(await number(document)).toBe(1);
  });
});
