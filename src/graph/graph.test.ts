import { describe, expect, it } from 'vitest';
import { english, saying } from '../../tests/support/inWords.ts';
import { inEnglish, msg } from '../messages/message.ts';
import { edgeError, validateDocument } from './analysis/validate.ts';
import { emptyDocument, type GraphDocument } from './document/document.ts';
import { CURRENT_VERSION, migrate } from './document/migrations.ts';
import { parseDocument, readDocument } from './document/parse.ts';
import { serializeDocument } from './document/serialize.ts';
import { applyCommand, type Command } from './edits/commands.ts';
import { endGesture, executeCommand, newHistory, undo } from './edits/history.ts';
import { CancelledError, Evaluator } from './evaluation/evaluator.ts';
import {
  type AbortSignalLike,
  NodeRefusal,
  type NodeType,
  type ProgressCallback,
  resolveParams,
  valueError,
} from './nodeType.ts';

/** A small library of number nodes: `value` → `sum` → `sum`. */
const runs: string[] = [];
const value: NodeType = {
  id: 'value',
  title: msg`value`,
  help: msg`value`,
  category: 'utility',
  params: { value: { kind: 'number', title: 'value', default: 1, min: -100, max: 100, step: 1 } },
  inputs: {},
  outputs: { number: { type: 'number' } },
  evaluate: (_inputs, params, work) => {
    runs.push(work.node);
    const result = params.value as number;
    if (result === 13)
      throw new NodeRefusal({ severity: 'error', code: 'test.unlucky', place: work.node, message: msg`13 is refused` });
    return { number: result };
  },
};
const sum: NodeType = {
  ...value,
  id: 'sum',
  params: {},
  inputs: { a: { type: 'number' }, b: { type: 'number', optional: true } },
  evaluate: async (inputs, _params, work) => {
    runs.push(work.node);
    return { number: (inputs.a as number) + ((inputs.b as number | undefined) ?? 0) };
  },
};
const text: NodeType = { ...value, id: 'text', params: {}, outputs: { text: { type: 'text' } } };
const registry = { value, sum, text };

const add = (node: string, type: string): Command => ({ kind: 'add-node', node, type, at: [0, 0] });
const edge = (from: string, to: string, input: string, output = 'number') => ({
  from: { node: from, output },
  to: { node: to, input },
});
const build = (...commands: Command[]): GraphDocument =>
  applyCommand(emptyDocument(), { kind: 'batch', commands }).document;
const example = () =>
  build(
    add('x', 'value'),
    add('y', 'value'),
    add('s', 'sum'),
    { kind: 'connect', edge: edge('x', 's', 'a') },
    { kind: 'connect', edge: edge('y', 's', 'b') },
  );
const set = (node: string, number?: number): Command => ({
  kind: 'set-param',
  node,
  param: 'value',
  ...(number === undefined ? {} : { value: number }),
});

describe('the document', () => {
  it('round-trips through text', () => {
    const document = example();
    expect(parseDocument(serializeDocument(document))).toEqual(document);
  });

  it('has a canonical text, independent of the order of edits', () => {
    const one = build(add('b', 'value'), add('a', 'value'));
    const other = build(add('a', 'value'), add('b', 'value'));
    expect(serializeDocument(one)).toBe(serializeDocument(other));
  });

  it.each([
    ['{', /not JSON/],
    ['[]', /expected/i],
    [JSON.stringify({ ...example(), version: CURRENT_VERSION + 1 }), /^version/],
    [JSON.stringify({ ...example(), extra: 1 }), /extra/],
    [JSON.stringify({ ...example(), nodes: { x: { type: 'value' } } }), /nodes\.x\.params/],
    [JSON.stringify({ ...example(), title: 7 }), /^title: .*it is 7$/],
    [
      JSON.stringify({ ...example(), frames: { f: { title: '', nodes: ['1st'], color: '#ffffff' } } }),
      /^frames\.f\.nodes\.0: a name is a letter .*it is "1st"$/,
    ],
  ])('rejects %s with the location', (input, message) => {
    expect(() => parseDocument(input)).toThrow(message);
  });

  it('a project of version 1 keeps its exposure, metered or manual', () => {
    const old = (params: object) => ({
      ...emptyDocument(),
      version: 1,
      nodes: { toneMap: { type: 'tone-map', params }, read: { type: 'read', params: { adapt: false } } },
    });
    const now = (params: object) => readDocument(old(params)).nodes;
    expect(now({ adapt: false, exposure: 2 }).toneMap).toEqual({
      type: 'tone-map',
      params: { exposure: 2, metering: 'manual' },
    });
    expect(now({ adapt: true }).toneMap?.params).toEqual({});
    expect(now({}).read?.params).toEqual({ adapt: false });
    expect(() => readDocument({ ...emptyDocument(), version: 1, nodes: 'none' })).toThrow('nodes');
  });

  it('a project of version 3 keeps its lighting and colours, by explicit nodes, also in groups', () => {
    const edge = (from: string, output: string, to: string, input: string) => [
      `${to}.${input}`,
      { from: { node: from, output }, to: { node: to, input } },
    ];
    const level = {
      nodes: {
        lighting: { type: 'number', params: {} },
        seen: { type: 'relativity-rasterize', params: { shadows: false, beaming: 0 } },
        tone: { type: 'tone-map', params: { falseColor: 'doppler', exposure: 1 } },
        output: { type: 'output', params: {} },
      },
      edges: Object.fromEntries([
        edge('seen', 'gbuffer', 'tone', 'gbuffer'),
        edge('tone', 'image', 'output', 'image'),
        edge('lighting', 'number', 'tone', 'exposure'),
      ]),
      layout: { seen: [0, 0], tone: [240, 0], output: [480, 0] },
      notes: {},
      frames: {},
    };
    const group = { ...level, title: 'Show', inputs: [], outputs: [] };
    const now = readDocument({ format: 'slowlight', version: 3, ...level, groups: { group }, files: {} });
    for (const { nodes, edges, layout } of [now, now.groups.group!]) {
      expect(nodes).toMatchObject({
        seen: { params: { beaming: 0 } },
        lighting: { type: 'number' },
        lighting2: { type: 'deferred-lighting', params: { shadows: false } },
        tone: { params: { exposure: 1 } },
        falseColour: { type: 'false-colour', params: { of: 'doppler' } },
      });
      expect(
        Object.values(edges)
          .map(({ from, to }) => `${from.node} ${to.node}.${to.input}`)
          .sort(),
      ).toEqual([
        'falseColour output.image',
        'lighting tone.exposure',
        'lighting2 tone.image',
        'seen lighting2.gbuffer',
        'tone falseColour.image',
      ]);
      expect(layout).toEqual({
        seen: [0, 0],
        lighting2: [240, 0],
        tone: [480, 0],
        falseColour: [720, 0],
        output: [960, 0],
      });
    }
  });

  it('a project of version 4 keeps the observer of its films in place, also in groups and by edges', () => {
    const edge = (to: string) => ({ from: { node: 'on', output: 'boolean' }, to: { node: to, input: 'hold' } });
    const level = {
      nodes: {
        on: { type: 'boolean', params: {} },
        film: { type: 'save-video', params: { hold: true, name: 'film.mp4' } },
        driven: { type: 'save-video', params: {} },
        other: { type: 'other', params: { hold: true } },
      },
      edges: { 'driven.hold': edge('driven'), 'other.hold': edge('other') },
      layout: {},
      notes: {},
      frames: {},
    };
    const group = { ...level, title: 'Films', inputs: [], outputs: [] };
    const now = readDocument({ format: 'slowlight', version: 4, ...level, groups: { group }, files: {} });
    for (const { nodes, edges } of [now, now.groups.group!]) {
      expect(nodes.film!.params).toEqual({ stayInPlace: true, name: 'film.mp4' });
      expect(nodes.other!.params).toEqual({ hold: true });
      expect(Object.keys(edges).sort()).toEqual(['driven.stayInPlace', 'other.hold']);
      expect(edges['driven.stayInPlace']!.to).toEqual({ node: 'driven', input: 'stayInPlace' });
    }
  });

  it('migrates the colours that a linear spectrum replaces (5)', () => {
    const nodes = {
      rasterize: { type: 'relativity-rasterize', params: { colors: 'shifted-primaries', beaming: 0 } },
      other: { type: 'other', params: { colors: 'shifted-primaries' } },
    };
    const level = { nodes, edges: {}, layout: {}, notes: {}, frames: {} };
    const now = readDocument({ format: 'slowlight', version: 5, ...level, groups: {}, files: {} });
    expect(now.nodes.rasterize!.params).toEqual({ colors: 'linear-spectrum', beaming: 0 });
    expect(now.nodes.other!.params).toEqual({ colors: 'shifted-primaries' });
  });

  it('migrates step by step', () => {
    const steps = {
      1: (data: Record<string, unknown>) => ({ ...data, trace: '1' }),
      2: (data: Record<string, unknown>) => ({ ...data, trace: `${String(data.trace)}2` }),
    };
    expect(migrate({ version: 1 }, steps, 3)).toEqual({ version: 3, trace: '12' });
    expect(migrate('no document')).toBe('no document');
  });
});

describe('commands', () => {
  it('one drag is one undo step', () => {
    let history = newHistory(example());
    for (let i = 0; i < 20; i++) history = executeCommand(history, set('x', i), 'value', 'drag');
    expect(history.past).toHaveLength(1);
    history = executeCommand(endGesture(history), set('x', 50), 'value', 'drag');
    expect(history.past).toHaveLength(2);
    expect(undo(undo(history)).document).toEqual(example());
  });

  it('an edit without effect is no undo step', () => {
    const history = executeCommand(newHistory(example()), set('x'), 'value');
    expect(history.past).toHaveLength(0);
  });

  it('a rejected command does not change the document', () => {
    const document = example();
    expect(() => applyCommand(document, set('nobody', 1))).toThrow(/no node "nobody"/);
    expect(() => applyCommand(document, add('x', 'sum'))).toThrow(/already a node/);
    expect(document).toEqual(example());
  });

  it('removing a node removes its edges, and undo restores them', () => {
    const history = executeCommand(newHistory(example()), { kind: 'remove-nodes', nodes: ['x'] }, 'remove');
    expect(Object.keys(history.document.edges)).toEqual(['s.b']);
    expect(undo(history).document).toEqual(example());
  });
});

describe('validation', () => {
  it('a valid document has no problems', () => {
    expect(validateDocument(example(), registry)).toEqual([]);
  });

  it('reports problems', () => {
    const document = build(
      add('s', 'sum'),
      add('t', 'text'),
      add('odd', 'nothing'),
      add('v', 'value'),
      set('v', 1000),
      { kind: 'connect', edge: edge('t', 's', 'a', 'text') },
    );
    const codes = validateDocument(document, registry).map((problem) => `${problem.code} ${inEnglish(problem.place)}`);
    expect(codes.sort()).toEqual(['graph.edge s', 'graph.param v.value', 'graph.unknown-node odd']);
  });

  it('rejects cycles of any length', () => {
    const document = build(add('a', 'sum'), add('b', 'sum'), { kind: 'connect', edge: edge('a', 'b', 'a') });
    expect(english(edgeError(document, edge('b', 'a', 'a'), registry))).toMatch(/cycle/);
    expect(english(edgeError(document, edge('a', 'a', 'a'), registry))).toMatch(/cycle/);
    expect(english(edgeError(document, edge('a', 'b', 'b'), registry))).toBeUndefined();
    expect(english(edgeError(document, edge('a', 'b', 'z'), registry))).toMatch(/no input "z"/);
  });

  it('checks values against their descriptions', () => {
    const number = value.params.value!;
    expect(valueError(number, 5)).toBeUndefined();
    expect(english(valueError(number, Number.NaN))).toMatch(/not a number/);
    expect(english(valueError({ ...number, integer: true } as typeof number, 0.5))).toMatch(/whole/);
    expect(english(valueError({ kind: 'boolean', title: '', default: true }, 'yes'))).toMatch(/neither true nor false/);
    const vector = { kind: 'vector', title: '', default: [0, 0, 1] } as const;
    expect(valueError(vector, [1, 2, 3])).toBeUndefined();
    for (const wrong of [[1, 2], [1, 2, Number.NaN], ['1', '2', '3'], 1])
      expect(english(valueError(vector, wrong))).toMatch(/three/);
    const list = { kind: 'list', title: '', default: [] } as const;
    expect(valueError(list, ['a', 'b'])).toBeUndefined();
    for (const wrong of ['a', [1], true]) expect(english(valueError(list, wrong))).toMatch(/no list/);
    const choice = { kind: 'choice', title: '', default: 'a', options: [{ value: 'a', title: '' }] } as const;
    expect(english(valueError(choice, 'b'))).toMatch(/none of the choices/);
  });

  it('a parameter is the set value, else the suggested, else the default one', () => {
    const suggested = { ...value, params: { value: { ...value.params.value!, suggestion: 'c' } } } as NodeType;
    expect(resolveParams(value, {})).toEqual({ value: 1 });
    expect(resolveParams(suggested, {})).toEqual({ value: undefined });
    expect(resolveParams(suggested, { value: 3 })).toEqual({ value: 3 });
  });
});

describe('evaluation', () => {
  const evaluate = async (evaluator: Evaluator<unknown>, document: GraphDocument, target = 's') => {
    runs.length = 0;
    const { target: result } = await evaluator.evaluate(document, target, {});
    return { result, ran: [...runs].sort() };
  };

  it('evaluates only what the target needs, and after an edit only what depends on it', async () => {
    const evaluator = new Evaluator(registry);
    const document = applyCommand(applyCommand(example(), add('idle', 'value')).document, set('y', 2)).document;
    expect(await evaluate(evaluator, document)).toEqual({
      result: { status: 'done', outputs: { number: 3 } },
      ran: ['s', 'x', 'y'],
    });
    const edited = applyCommand(document, set('y', 5)).document;
    expect((await evaluate(evaluator, edited)).ran).toEqual(['s', 'y']);
    expect((await evaluate(evaluator, document)).ran).toEqual([]);
  });

  it('equal content is computed once', async () => {
    expect((await evaluate(new Evaluator(registry), example())).ran.filter((id) => id !== 's')).toHaveLength(1);
  });

  it('an error stays on its node with its cause, and blocks what follows', async () => {
    const document = applyCommand(example(), set('x', 13)).document;
    const evaluation = await new Evaluator(registry).evaluate(document, 's', {});
    expect(evaluation.target).toEqual({ status: 'blocked', by: 'x' });
    expect(evaluation.results.get('x')).toMatchObject({
      status: 'failed',
      problem: { code: 'test.unlucky', place: 'x' },
    });
  });

  it('a cycle and a missing input are problems, not hangs', async () => {
    const circle = build(add('a', 'sum'), { kind: 'connect', edge: edge('a', 'a', 'a') });
    expect((await evaluate(new Evaluator(registry), circle, 'a')).result).toMatchObject({
      problem: { code: 'graph.cycle' },
    });
    expect((await evaluate(new Evaluator(registry), build(add('a', 'sum')), 'a')).result).toMatchObject({
      problem: { code: 'graph.input' },
    });
  });

  it('stops where it is cancelled', async () => {
    const abort = new AbortController();
    abort.abort();
    const evaluation = new Evaluator(registry).evaluate(example(), 's', {}, { signal: abort.signal });
    await expect(evaluation).rejects.toThrow(CancelledError);
  });

  it('two evaluations at once share the work', async () => {
    let started = 0;
    const slow: NodeType = {
      ...value,
      evaluate: async () => {
        started++;
        await new Promise((done) => setTimeout(done, 5));
        return { number: 1 };
      },
    };
    const evaluator = new Evaluator({ value: slow });
    const document = build(add('x', 'value'));
    await Promise.all([evaluator.evaluate(document, 'x', {}), evaluator.evaluate(document, 'x', {})]);
    expect(started).toBe(1);
  });

  it('evicts the least recently used result first', async () => {
    const evaluator = new Evaluator(registry, { capacity: 1 });
    const at = (number: number) => evaluate(evaluator, build(add('x', 'value'), set('x', number)), 'x');
    for (const number of [1, 2, 1, 3]) await at(number);
    expect((await at(1)).ran).toEqual([]);
    expect((await at(2)).ran).toEqual(['x']);
  });

  it('equal inputs share results, whatever produced them', async () => {
    const evaluator = new Evaluator(registry);
    const sums = (a: number, b: number) => {
      const inner = { ...example(), edges: { 's.a': edge('x', 's', 'a'), 's.b': edge('y', 's', 'b') } };
      return applyCommand(inner, {
        kind: 'batch',
        commands: [set('x', a), set('y', b), add('t', 'sum'), { kind: 'connect', edge: edge('s', 't', 'a') }],
      }).document;
    };
    expect((await evaluate(evaluator, sums(2, 3), 't')).ran).toEqual(['s', 't', 'x', 'y']);
    expect(await evaluate(evaluator, sums(4, 1), 't')).toEqual({
      result: { status: 'done', outputs: { number: 5 } },
      ran: ['s', 'x', 'y'],
    });
  });

  it('results of the latest evaluation stay cached, whatever their size', async () => {
    const evaluator = new Evaluator(registry, { capacity: 1 });
    const count = 200;
    const chain = build(
      add('n0', 'value'),
      ...Array.from({ length: count }, (_, i): Command[] => [
        add(`n${i + 1}`, 'sum'),
        { kind: 'connect', edge: edge(`n${i}`, `n${i + 1}`, 'a') },
        { kind: 'connect', edge: edge(`n${Math.max(0, i - 1)}`, `n${i + 1}`, 'b') },
      ]).flat(),
    );
    expect((await evaluate(evaluator, chain, `n${count}`)).ran).toHaveLength(count + 1);
    expect((await evaluate(evaluator, chain, `n${count}`)).ran).toEqual([]);
  });

  it('node positions do not affect evaluation; targets and services do', async () => {
    const evaluator = new Evaluator(registry);
    const services = {};
    const before = await evaluator.evaluate(example(), 's', services);
    const { document } = applyCommand(example(), { kind: 'batch', commands: [] });
    expect(await evaluator.evaluate(document, 's', services)).not.toBe(before);
    const again = await evaluator.evaluate(document, 's', services);
    const moved = applyCommand(document, { kind: 'move-nodes', to: { x: [5, 5] } }).document;
    expect(await evaluator.evaluate(moved, 's', services)).toBe(again);
    expect((await evaluator.evaluate(moved, 'x', services)).target).toEqual({ status: 'done', outputs: { number: 1 } });
    expect(await evaluator.evaluate(moved, 'x', {})).not.toBe(await evaluator.evaluate(moved, 'x', services));
  });

  it('a refusal is reported at each node that has it', async () => {
    const evaluator = new Evaluator(registry);
    const both = applyCommand(applyCommand(example(), set('x', 13)).document, set('y', 13)).document;
    const { results } = await evaluator.evaluate(both, ['x', 'y'], {});
    for (const node of ['x', 'y']) expect(results.get(node)).toMatchObject({ problem: { place: node } });
  });

  it('shared work continues until both evaluations are cancelled, and reports progress to both', async () => {
    const begun: {
      signal?: AbortSignalLike;
      progress: ProgressCallback;
      done: (outputs: { number: number }) => void;
    }[] = [];
    const slow: NodeType = {
      ...value,
      evaluate: (_inputs, _params, { signal, progress }) =>
        new Promise((done, fail) => {
          begun.push({ signal, progress, done });
          signal?.addEventListener('abort', () => fail(new Error('stopped')));
        }),
    };
    const evaluator = new Evaluator({ value: slow });
    const heard: string[] = [];
    const start = (name: string) => {
      const abort = new AbortController();
      const progress = (node: string, part: number | undefined) => heard.push(`${name} ${node} ${part}`);
      const how = { signal: abort.signal, progress };
      return { abort, ended: evaluator.evaluate(build(add(name, 'value')), name, {}, how) };
    };
    const [first, second] = [start('x'), start('y')];
    begun[0]?.progress(0.5);
    expect(heard).toEqual(['x x 0.5', 'y y 0.5']);
    first.abort.abort();
    await expect(first.ended).rejects.toThrow(CancelledError);
    expect(begun[0]?.signal?.aborted).toBe(false);
    second.abort.abort();
    await expect(second.ended).rejects.toThrow(CancelledError);
    expect(begun[0]?.signal?.aborted).toBe(true);

    const third = start('x');
    const fourth = start('y');
    third.abort.abort();
    await expect(third.ended).rejects.toThrow(CancelledError);
    begun[1]?.done({ number: 7 });
    expect((await fourth.ended).target).toEqual({ status: 'done', outputs: { number: 7 } });
    expect(begun).toHaveLength(2);
  });

  it('unexpected errors are not cached', async () => {
    let tries = 0;
    const flaky: NodeType = {
      ...value,
      evaluate: async () => {
        if (++tries === 1) throw new Error('the network is down');
        return { number: tries };
      },
    };
    const evaluator = new Evaluator({ value: flaky });
    const target = async () => (await evaluator.evaluate(build(add('x', 'value')), 'x', {})).target;
    expect(await target()).toMatchObject({
      problem: { code: 'graph.evaluation', message: saying(/^the network is down$/) },
    });
    expect(await target()).toMatchObject({ outputs: { number: 2 } });
  });
});
