import { flatten } from '../../src/graph/analysis/flatten.ts';
import type { GraphDocument } from '../../src/graph/document/document.ts';
import { applyCommand, type Command } from '../../src/graph/edits/commands.ts';
import { copyFragment, pasteFragment } from '../../src/graph/edits/fragment.ts';
import { executeCommand, newHistory, redo, undo } from '../../src/graph/edits/history.ts';
import { Evaluator } from '../../src/graph/evaluation/evaluator.ts';
import { nodeLibrary } from '../../src/nodes/library.ts';
import { workerServices } from '../../src/nodes/services.ts';
import { add, build, connect, set } from '../../tests/support/graphKit.ts';
import { type Bench, interleaved, type Table } from '../support/bench.ts';

const SIZES = [30, 300];
const ROUNDS = 60;

export const graph: Bench = {
  name: 'graph',
  title: 'The node graph',
  about:
    'What the engine itself costs, on one core: graphs of arithmetic, of which each node takes two others’ results, so that the time is the engine’s. A frame in which nothing changed evaluates nothing in the program; ' +
    'here it is asked anyway. An edit goes all the way: the command, the history, the flat graph, and all results that depend on it.',
  run: async () => [await evaluation(), await edits()],
};

/** Two numbers, and nodes that each add the previous two, modulo 1000. */
function arithmetic(size: number): GraphDocument {
  const nodes = Array.from({ length: size - 2 }, (_, i): Command[] => [
    add(`n${i}`, 'math', [240 * i, 0]),
    set(`n${i}`, 'operation', i % 2 ? 'mix' : 'maximum'),
    connect(i === 0 ? 'a.number' : `n${i - 1}.number`, `n${i}.a`),
    connect(i < 2 ? 'b.number' : `n${i - 2}.number`, `n${i}.b`),
  ]);
  return build(add('a', 'number'), add('b', 'number'), ...nodes.flat());
}

async function evaluation(): Promise<Table> {
  const rows: (string | number)[][] = [];
  for (const size of SIZES) {
    const target = `n${size - 3}`;
    // Each kind of work has its own evaluator and cache, as a page that does only this.
    const evaluators = [0, 1, 2].map(() => new Evaluator(nodeLibrary));
    const evaluate = async (document: GraphDocument, which: number): Promise<void> => {
      const evaluator = evaluators[which]!;
      const { target: result } = await evaluator.evaluate(document, target, workerServices);
      if (result.status !== 'done') throw new Error(`the graph of ${size} nodes was not evaluated`);
    };
    const still = arithmetic(size);
    await evaluate(still, 0);
    let [first, last] = [newHistory(still), newHistory(still)];
    let value = 0;
    const dragged = (history: typeof first, node: string, param: string) =>
      executeCommand(history, set(node, param, ++value / 1000), 'drag', 'drag');
    const [same, start, end, flat] = await interleaved(
      [
        () => evaluate(still, 0),
        () => {
          first = dragged(first, 'a', 'number');
          return evaluate(first.document, 1);
        },
        () => {
          last = dragged(last, target, 'c');
          return evaluate(last.document, 2);
        },
        () => void flatten({ ...still }, nodeLibrary),
      ],
      ROUNDS,
    );
    rows.push([`${size}`, same!, start!, end!, flat!]);
  }
  return {
    columns: [
      'nodes',
      'nothing changed [ms]',
      'edit of the first number [ms]',
      'edit of the last node [ms]',
      'of it, opening groups out [ms]',
    ],
    rows,
  };
}

async function edits(): Promise<Table> {
  const rows: (string | number)[][] = [];
  for (const size of [20, 2000]) {
    const document = arithmetic(size);
    const fragment = copyFragment(document, { nodes: Object.keys(document.nodes) });
    const { command } = pasteFragment(document, fragment);
    const pasted = executeCommand(newHistory(document), command, 'paste');
    const undone = undo(pasted);
    const [copy, paste, back, again, move] = await interleaved(
      [
        () => void copyFragment(document, { nodes: Object.keys(document.nodes) }),
        () => void executeCommand(newHistory(document), pasteFragment(document, fragment).command, 'paste'),
        () => void undo(pasted),
        () => void redo(undone),
        () => void applyCommand(pasted.document, { kind: 'move-nodes', to: { n0: [1, 1] } }),
      ],
      20,
    );
    rows.push([size.toLocaleString('en'), copy!, paste!, back!, again!, move!]);
  }
  return {
    columns: ['nodes', 'copy [ms]', 'paste [ms]', 'undo of it [ms]', 'redo [ms]', 'then moving one node [ms]'],
    rows,
    remark: 'Pasted into a document of as many nodes.',
  };
}
