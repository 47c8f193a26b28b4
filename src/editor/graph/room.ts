import type { Point } from '../../graph/commands.ts';
import { type Graph, type GraphNode, own } from '../../graph/document.ts';
import type { Fragment } from '../../graph/edits/fragment.ts';
import { middleOf } from '../../graph/edits/renamed.ts';
import { inputName, type Level, socketsOf } from '../../graph/sockets.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { canvas } from './canvas.ts';
import type { Addition } from './edits.ts';
import { endsIn, faceOf, pictureFor } from './face.ts';
import { around, type Box, freePlace, sizeOf } from './shape.ts';

type Nodes = Pick<Graph, 'nodes' | 'edges'>;

/** As large as nodes can become that are not on the canvas yet: with a picture wherever what they give can be shown as one. */
function sizesOf(level: Level, { nodes, edges }: Nodes): ReadonlyMap<string, Point> {
  const typeOf = (id: string, side: 'inputs' | 'outputs', name: string): string | undefined => {
    const sockets = socketsOf(level, nodes[id]!, nodeLibrary)?.[side] ?? {};
    return own(sockets, inputName(name).base)?.type;
  };
  const surroundings = {
    level,
    types: { typeOf, conflicts: [] },
    edges: endsIn(edges),
    resultOf: () => undefined,
    problemOf: () => undefined,
    pictures: false,
  };
  const { pictures } = canvas.getState();
  return new Map(
    Object.entries(nodes).map(([id, node]) => {
      const face = faceOf(id, node, surroundings);
      const first = face.rows.find(({ output }) => output)?.output;
      return [id, sizeOf({ ...face, ...(pictures && pictureFor(node, first)) })];
    }),
  );
}

/** What is on a level, as the canvas shows it, or where none does, as it would. */
function boxesIn(level: Level): readonly Box[] {
  const { graph } = level;
  const { sight } = canvas.getState();
  const sizes = sight ? undefined : sizesOf(level, graph);
  const notes = Object.values(graph.notes).map(({ at, size }) => ({ at, size }));
  return Object.keys(graph.nodes)
    .map((id): Box => {
      const at = sight?.placeOf(id) ?? graph.layout[id] ?? [0, 0];
      return { at, size: sight?.sizeOf(id) ?? sizes?.get(id) ?? [0, 0] };
    })
    .concat(notes);
}

/** Where a new node covers nothing that is there. */
export function freePlaceIn(level: Level, { type, group }: Addition, wanted: Point): Point {
  const node: GraphNode = { type, params: group === undefined ? {} : { group } };
  const size = sizesOf(level, { nodes: { added: node }, edges: {} }).get('added') ?? [0, 0];
  return freePlace(wanted, size, boxesIn(level));
}

/** Where the middle of nodes that are pasted is to come, as `pasteOf` has it, so that they cover nothing: around `middle`, or where they were, or below that. */
export function freeMiddle(level: Level, fragment: Fragment, middle?: Point): Point {
  const sizes = sizesOf(level, fragment);
  const nodes = Object.entries(fragment.layout).map(([id, at]): Box => ({ at, size: sizes.get(id) ?? [0, 0] }));
  const notes = Object.values(fragment.notes).map(({ at, size }): Box => ({ at, size }));
  const { at, size } = around([...nodes, ...notes]) ?? { at: [0, 0], size: [0, 0] };
  const wanted: Point = middle ? [middle[0] - size[0] / 2, middle[1] - size[1] / 2] : at;
  const free = freePlace(wanted, size, boxesIn(level));
  const [x, y] = middleOf(Object.values(fragment.layout));
  return [Math.round(x + free[0] - at[0]), Math.round(y + free[1] - at[1])];
}

/** Where what was added is not all to be seen, what is seen follows; once it is drawn. */
export function bringIntoSight(nodes: readonly string[]): void {
  requestAnimationFrame(() => {
    const { sight } = canvas.getState();
    if (sight && !nodes.every(sight.sees)) sight.fit(nodes);
  });
}
