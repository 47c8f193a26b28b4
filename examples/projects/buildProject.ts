import { emptyDocument, type GraphDocument, type ParamValue } from '../../src/graph/document/document.ts';
import { applyCommand, type Command } from '../../src/graph/edits/commands.ts';

/** A node with its non-default parameters and its inputs: `input: 'node.output'`, or a list for a multi-input. */
export interface NodeSketch {
  readonly type: string;
  readonly set?: Readonly<Record<string, ParamValue>>;
  readonly from?: Readonly<Record<string, string | readonly string[]>>;
}

type About = Required<Pick<GraphDocument, 'title' | 'lookFor'>>;

const COLUMN = 260;
/** Nodes with previews are taller. */
const ROW = 210;

/** A project from a sketch, with title and viewing hint; each node is one column to the right of its inputs. */
export function build(about: About, nodes: Readonly<Record<string, NodeSketch>>): GraphDocument {
  const columns = new Map<string, number>();
  const rows = new Map<number, number>();
  const columnOf = (id: string): number => {
    const known = columns.get(id);
    if (known !== undefined) return known;
    const column = Math.max(-1, ...sources(nodes[id]!).map(([, from]) => columnOf(nodeOf(from)))) + 1;
    columns.set(id, column);
    return column;
  };
  const place = (id: string): readonly [number, number] => {
    const column = columnOf(id);
    const row = rows.get(column) ?? 0;
    rows.set(column, row + 1);
    return [COLUMN * column, ROW * row];
  };
  const ids = Object.keys(nodes);
  const added = ids.map((node): Command => ({ kind: 'add-node', node, type: nodes[node]!.type, at: place(node) }));
  const set = ids.flatMap((node) =>
    Object.entries(nodes[node]!.set ?? {}).map(
      ([param, value]): Command => ({ kind: 'set-param', node, param, value }),
    ),
  );
  const joined = ids.flatMap((node) =>
    sources(nodes[node]!).map(([input, from]): Command => {
      const [source, output] = from.split('.') as [string, string];
      return { kind: 'connect', edge: { from: { node: source, output }, to: { node, input } } };
    }),
  );
  const whole = applyCommand(emptyDocument(), { kind: 'batch', commands: [...added, ...set, ...joined] }).document;
  return { ...whole, ...about };
}

const nodeOf = (from: string): string => from.split('.')[0]!;

const sources = ({ from = {} }: NodeSketch): [input: string, from: string][] =>
  Object.entries(from).flatMap(([input, source]) =>
    typeof source === 'string'
      ? [[input, source] as [string, string]]
      : source.map((each, i) => [`${input}.${i + 1}`, each] as [string, string]),
  );
