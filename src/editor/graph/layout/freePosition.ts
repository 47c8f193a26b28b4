import { type GraphLevel, inputName, socketsOf } from '../../../graph/analysis/sockets.ts';
import { type Graph, type GraphNode, own } from '../../../graph/document/document.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import type { Fragment } from '../../../graph/edits/fragment.ts';
import { layoutCenter } from '../../../graph/edits/subgraph.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { canvas } from '../canvas/canvasState.ts';
import { boundingRect, type CanvasRect, cardSize, freePosition } from '../cards/cardGeometry.ts';
import { cardModel, connectedSockets, pictureModeOf } from '../cards/cardModel.ts';
import type { AddableNode } from '../commands/edits.ts';

type Nodes = Pick<Graph, 'nodes' | 'edges'>;

/** Sizes of nodes that are not on the canvas yet: with a picture wherever their output type can have one. */
function estimatedSizes(level: GraphLevel, { nodes, edges }: Nodes): ReadonlyMap<string, CanvasPoint> {
  const typeOf = (id: string, side: 'inputs' | 'outputs', name: string): string | undefined => {
    const sockets = socketsOf(level, nodes[id]!, nodeLibrary)?.[side] ?? {};
    return own(sockets, inputName(name).base)?.type;
  };
  const surroundings = {
    level,
    types: { typeOf, conflicts: [] },
    edges: connectedSockets(edges),
    resultOf: () => undefined,
    problemOf: () => undefined,
    pictures: false,
  };
  const { pictures } = canvas.getState();
  return new Map(
    Object.entries(nodes).map(([id, node]) => {
      const card = cardModel(id, node, surroundings);
      const first = card.rows.find(({ output }) => output)?.output;
      return [id, cardSize({ ...card, ...(pictures && pictureModeOf(node, first)) })];
    }),
  );
}

/** Occupied rectangles of a level, as shown on the canvas, or estimated if it is not shown. */
function occupiedRects(level: GraphLevel): readonly CanvasRect[] {
  const { graph } = level;
  const { viewport } = canvas.getState();
  const sizes = viewport ? undefined : estimatedSizes(level, graph);
  const notes = Object.values(graph.notes).map(({ at, size }) => ({ at, size }));
  return Object.keys(graph.nodes)
    .map((id): CanvasRect => {
      const at = viewport?.positionOf(id) ?? graph.layout[id] ?? [0, 0];
      return { at, size: viewport?.sizeOf(id) ?? sizes?.get(id) ?? [0, 0] };
    })
    .concat(notes);
}

/** A position at which a new node covers nothing. */
export function findFreePosition(level: GraphLevel, { type, group }: AddableNode, wanted: CanvasPoint): CanvasPoint {
  const node: GraphNode = { type, params: group === undefined ? {} : { group } };
  const size = estimatedSizes(level, { nodes: { added: node }, edges: {} }).get('added') ?? [0, 0];
  return freePosition(wanted, size, occupiedRects(level));
}

/**
 * Center for pasted nodes (see `pasteFragment`) at which they cover nothing: at or below `middle`, or their original
 * position.
 */
export function findFreeCenter(level: GraphLevel, fragment: Fragment, middle?: CanvasPoint): CanvasPoint {
  const sizes = estimatedSizes(level, fragment);
  const nodes = Object.entries(fragment.layout).map(([id, at]): CanvasRect => ({ at, size: sizes.get(id) ?? [0, 0] }));
  const notes = Object.values(fragment.notes).map(({ at, size }): CanvasRect => ({ at, size }));
  const { at, size } = boundingRect([...nodes, ...notes]) ?? { at: [0, 0], size: [0, 0] };
  const wanted: CanvasPoint = middle ? [middle[0] - size[0] / 2, middle[1] - size[1] / 2] : at;
  const free = freePosition(wanted, size, occupiedRects(level));
  const [x, y] = layoutCenter(Object.values(fragment.layout));
  return [Math.round(x + free[0] - at[0]), Math.round(y + free[1] - at[1])];
}

/** Scrolls added nodes into view, once rendered. */
export function revealNodes(nodes: readonly string[]): void {
  requestAnimationFrame(() => {
    const { viewport } = canvas.getState();
    if (viewport && !nodes.every(viewport.isVisible)) viewport.fit(nodes);
  });
}
