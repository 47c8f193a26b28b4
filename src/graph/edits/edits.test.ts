import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { add, build, connect, documents, edited, seeds, set, toys, tried } from '../../../tests/support/graphKit.ts';
import { type FlatSource, flatten } from '../analysis/flatten.ts';
import { emptyDocument, emptyGraph, type GraphDocument } from '../document/document.ts';
import { readDocument } from '../document/parse.ts';
import { serializeDocument } from '../document/serialize.ts';
import { GROUP } from '../document/structuralTypes.ts';
import { Evaluator } from '../evaluation/evaluator.ts';
import { alignCommand, distributeCommand } from './arrange.ts';
import { applyCommand, type Command, CommandError } from './commands.ts';
import { copyFragment, duplicateSelection, parseFragment, pasteFragment, serializeFragment } from './fragment.ts';
import { groupCommand } from './group.ts';
import { executeCommand, newHistory, redo, undo } from './history.ts';
import { ungroupCommand } from './ungroup.ts';

/** Description of what is evaluated, independent of groups and of key order. */
function wiring(document: GraphDocument): string[] {
  const bare = (id: string) => id.slice(id.lastIndexOf('/') + 1);
  const words = (source: FlatSource) =>
    source.kind === 'output' ? `${bare(source.node)}.${source.output}` : 'nothing';
  return [...flatten(document, toys).nodes.values()]
    .map(({ id, type, params, inputs }) => {
      const fed = [...inputs].map(([name, sources]) => `${name}=${sources.map(words).join('+')}`).sort();
      return `${bare(id)}: ${type} ${JSON.stringify(params)} ${fed.join(' ')}`;
    })
    .sort();
}

/** x and y are added; then s is scaled twice and shown. */
const chain = (): GraphDocument =>
  build(
    add('x', 'value', [0, 0]),
    add('y', 'value', [0, 100]),
    add('s', 'sum', [200, 50]),
    add('w', 'weigh', [400, 50]),
    add('out', 'sum', [600, 50]),
    set('x', 'value', 5),
    set('y', 'value', 7),
    connect('x.number', 's.a'),
    connect('y.number', 's.b'),
    connect('s.number', 'w.items.1'),
    connect('s.number', 'w.items.2'),
    connect('w.number', 'out.a'),
    connect('x.number', 'out.bias'),
  );
const resultOf = async (document: GraphDocument, node = 'out') => {
  const { target } = await new Evaluator(toys).evaluate(document, node, {});
  return target.status === 'done' ? target.outputs.number : target;
};

describe('commands', () => {
  it('of all kinds, in groups too, can be undone and redone exactly, and yield readable documents', () => {
    fc.assert(
      fc.property(seeds(40), (list) => {
        let history = newHistory(emptyDocument());
        const walk = [serializeDocument(history.document)];
        for (const seed of list) {
          const next = tried(history.document, seed);
          if (!next) continue;
          const before = history;
          history = executeCommand(history, next.command, 'step');
          if (history !== before) walk.push(serializeDocument(history.document));
        }
        expect(readDocument(JSON.parse(walk.at(-1)!))).toEqual(history.document);
        expect(history.past.length).toBe(walk.length - 1);
        for (const state of walk.slice(0, -1).reverse()) {
          history = undo(history);
          expect(serializeDocument(history.document)).toBe(state);
        }
        for (const state of walk.slice(1)) {
          history = redo(history);
          expect(serializeDocument(history.document)).toBe(state);
        }
      }),
      { numRuns: 150 },
    );
  });

  it('a long drag of many nodes is stored compactly', () => {
    let history = newHistory(chain());
    for (let i = 0; i < 500; i++)
      history = executeCommand(history, { kind: 'move-nodes', to: { x: [i, 1], y: [i, 2] } }, 'move', 'drag');
    expect(history.past).toHaveLength(1);
    expect(history.past[0]!.patches.length).toBeLessThan(8);
    expect(history.document.layout).toMatchObject({ x: [499, 1], y: [499, 2] });
    expect(redo(undo(history)).document).toEqual(history.document);
    expect(undo(history).document).toEqual(chain());
  });

  it('are rejected if the document would be unreadable', () => {
    const grouped = applyCommand(chain(), groupCommand(chain(), { nodes: ['s'] }, 'g', toys).command).document;
    const itself = {
      kind: 'inside',
      group: 'group',
      command: { kind: 'add-node', node: 'i', type: GROUP, at: [0, 0], params: { group: 'group' } },
    } as const;
    expect(() => applyCommand(grouped, itself)).toThrow(/groups.group: it holds itself: group → group/);
    expect(() => applyCommand(grouped, { kind: 'inside', group: 'none', command: add('a', 'sum') })).toThrow(
      /no group/,
    );
    expect(() => applyCommand(grouped, add('1', 'sum'))).toThrow(CommandError);
    expect(() =>
      applyCommand(grouped, { kind: 'set-frame', frame: 'f', value: { title: '', nodes: ['gone'] } }),
    ).toThrow(/frames.f.nodes: there is no node "gone"/);
    expect(() => applyCommand(grouped, { kind: 'rename', node: 'constructor', title: 'x' })).toThrow(/no node/);
  });

  it('do not modify their input, also if one command changes the result of another', () => {
    const value = { title: 'g', ...emptyGraph(), inputs: [], outputs: [] };
    const command: Command = {
      kind: 'batch',
      commands: [
        { kind: 'set-group', group: 'g', value },
        { kind: 'inside', group: 'g', command: add('a', 'sum') },
        { kind: 'inside', group: 'g', command: set('a', 'bias', 2) },
      ],
    };
    expect(edited(emptyDocument(), command).groups.g!.nodes.a!.params).toEqual({ bias: 2 });
    expect(value.nodes).toEqual({});
  });

  it('repeating an existing connection is no edit', () => {
    const document = chain();
    expect(applyCommand(document, connect('x.number', 's.a')).document).toBe(document);
  });
});

describe('a group', () => {
  it('computes the same as its nodes, with one socket per source', async () => {
    const before = chain();
    const { command, node, group } = groupCommand(before, { nodes: ['s', 'w'] }, 'Sum', toys);
    const after = applyCommand(before, command).document;
    expect(after.groups[group]).toMatchObject({
      title: 'Sum',
      inputs: [
        { name: 'a', type: 'number' },
        { name: 'b', type: 'number' },
      ],
      outputs: [{ name: 'number', type: 'number' }],
    });
    expect(Object.keys(after.nodes).sort()).toEqual([node, 'out', 'x', 'y'].sort());
    expect(wiring(after)).toEqual(wiring(before));
    expect(await resultOf(after)).toBe(41);
    expect(await resultOf(before)).toBe(41);
    const open = ungroupCommand(after, node);
    const back = applyCommand(after, open.command).document;
    expect([back.nodes, back.edges, back.groups]).toEqual([before.nodes, before.edges, {}]);
  });

  it('of any part of any document does not change results, and can be ungrouped', () => {
    let grouped = 0;
    fc.assert(
      fc.property(documents(40), fc.array(fc.nat(99), { minLength: 1, maxLength: 6 }), (document, picks) => {
        const ids = Object.keys(document.nodes);
        fc.pre(ids.length > 0);
        const nodes = [...new Set(picks.map((pick) => ids[pick % ids.length]!))];
        let command: ReturnType<typeof groupCommand>;
        try {
          command = groupCommand(document, { nodes }, 'any', toys);
        } catch (error) {
          expect(error).toBeInstanceOf(CommandError);
          return;
        }
        grouped++;
        const after = applyCommand(document, command.command).document;
        expect(wiring(after)).toEqual(wiring(document));
        const back = applyCommand(after, ungroupCommand(after, command.node).command).document;
        expect(wiring(back)).toEqual(wiring(document));
      }),
      { numRuns: 300 },
    );
    expect(grouped).toBeGreaterThan(100);
  });

  it('is rejected if it would create a cycle', () => {
    expect(() => groupCommand(chain(), { nodes: ['s', 'out'] }, 'g', toys)).toThrow(/feed itself over w/);
    expect(() => groupCommand(chain(), { nodes: [] }, 'g', toys)).toThrow(/choose/);
    expect(() => ungroupCommand(chain(), 'x')).toThrow(/no group/);
  });
});

describe('copies', () => {
  it('of any selection are equal to it, and placed beside it', () => {
    fc.assert(
      fc.property(documents(40), fc.array(fc.nat(99), { minLength: 1, maxLength: 8 }), (document, picks) => {
        const ids = Object.keys(document.nodes);
        fc.pre(ids.length > 0);
        const chosen = [...new Set(picks.map((pick) => ids[pick % ids.length]!))];
        const copied = copyFragment(document, { nodes: chosen });
        const fragment = parseFragment(serializeFragment(copied));
        expect(fragment).toEqual(copied);
        const alone = edited(emptyDocument(), pasteFragment(emptyDocument(), fragment).command);
        const { command, nodes } = pasteFragment(document, fragment);
        const pasted = applyCommand(document, command).document;
        expect(nodes).toHaveLength(chosen.length);
        // Copied again from where it was pasted, into an empty document, it is unchanged.
        const again = edited(emptyDocument(), pasteFragment(emptyDocument(), copyFragment(pasted, { nodes })).command);
        const kinds = (graph: GraphDocument) =>
          wiring(graph)
            .map((line) => line.replace(/\b[a-z]+\d*(?=[:.])/g, '_'))
            .sort();
        expect(kinds(again)).toEqual(kinds(alone));
        expect(Object.keys(pasted.nodes)).toHaveLength(ids.length + chosen.length);
        for (const id of ids) expect(pasted.nodes[id]).toEqual(document.nodes[id]);
      }),
      { numRuns: 200 },
    );
  });

  it('include their groups, once', () => {
    const grouping = groupCommand(chain(), { nodes: ['s', 'w'] }, 'Sum', toys);
    const document = applyCommand(chain(), grouping.command).document;
    const selection = { nodes: [grouping.node] };
    expect(
      Object.keys(applyCommand(document, duplicateSelection(document, selection).command).document.groups),
    ).toEqual(['group']);
    const fragment = copyFragment(document, selection);
    const other = edited(document, { kind: 'inside', group: 'group', command: set('s', 'bias', 3) });
    const both = applyCommand(other, pasteFragment(other, fragment).command).document;
    expect(Object.keys(both.groups)).toEqual(['group', 'group2']);
    expect(both.groups.group2).toEqual(document.groups.group);
    expect(both.nodes.group2!.params).toEqual({ group: 'group2' });
  });

  it('are placed at the given position', () => {
    const { command, nodes } = pasteFragment(
      chain(),
      copyFragment(chain(), { nodes: ['x', 'y'] }),
      undefined,
      [1000, 1000],
    );
    const { layout } = applyCommand(chain(), command).document;
    expect(nodes.map((id) => layout[id])).toEqual([
      [1000, 950],
      [1000, 1050],
    ]);
  });

  it.each([
    ['{', /not JSON/],
    ['{"format":"slowlight"}', /no nodes of Slowlight/],
    ['null', /no nodes of Slowlight/],
    [serializeFragment({ ...copyFragment(chain(), { nodes: ['x'] }), version: 99 as 6 }), /^version/],
    [
      serializeFragment({ ...copyFragment(chain(), { nodes: ['x'] }), layout: { y: [0, 0] } }),
      /layout.y: there is no node "y"/,
    ],
  ])('refuse %s', (text, message) => {
    expect(() => parseFragment(text)).toThrow(message);
  });
});

describe('arranging', () => {
  const sizeOf = (node: string) => [node === 'x' ? 100 : 200, 50] as const;
  const placed = build(add('x', 'value', [10, 0]), add('y', 'value', [50, 300]), add('s', 'sum', [400, 90]));
  const layout = (command: Parameters<typeof applyCommand>[1]) => applyCommand(placed, command).document.layout;
  const nodes = ['x', 'y', 's'];

  it.each([
    ['left', { x: [10, 0], y: [10, 300], s: [10, 90] }],
    ['right', { x: [500, 0], y: [400, 300], s: [400, 90] }],
    ['center', { x: [255, 0], y: [205, 300], s: [205, 90] }],
    ['top', { x: [10, 0], y: [50, 0], s: [400, 0] }],
    ['bottom', { x: [10, 300], y: [50, 300], s: [400, 300] }],
  ] as const)('aligns nodes: %s', (to, wanted) => {
    expect(layout(alignCommand(placed, { nodes }, to, sizeOf))).toEqual(wanted);
  });

  it('distributes them evenly', () => {
    expect(layout(distributeCommand(placed, { nodes }, 1, sizeOf))).toEqual({
      x: [10, 0],
      s: [400, 150],
      y: [50, 300],
    });
    expect(layout(distributeCommand(placed, { nodes: ['x'] }, 1, sizeOf))).toEqual(placed.layout);
  });
});
