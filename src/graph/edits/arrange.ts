import { type GraphDocument, graphIn, own } from '../document/document.ts';
import type { CanvasPoint, Command } from './commands.ts';
import { type GraphSelection, insideGroup } from './fragment.ts';

/** The edges or centers to align. */
export type Alignment = 'left' | 'center' | 'right' | 'top' | 'middle' | 'bottom';

/** A node's position and size on the canvas [px]. */
interface NodeBox {
  readonly node: string;
  readonly at: CanvasPoint;
  readonly size: CanvasPoint;
}

/** Width and height of a node on the canvas [px]. */
export type SizeOf = (node: string) => CanvasPoint;

/** Aligns the selected nodes with the outermost of them, or with their center. */
export function alignCommand(
  document: GraphDocument,
  selection: GraphSelection,
  to: Alignment,
  sizeOf: SizeOf,
): Command {
  const boxes = nodeBoxes(document, selection, sizeOf);
  const axis = to === 'left' || to === 'center' || to === 'right' ? 0 : 1;
  // Position of the alignment line relative to each node's size: 0, ½, 1.
  const share = to === 'left' || to === 'top' ? 0 : to === 'center' || to === 'middle' ? 0.5 : 1;
  const low = Math.min(...boxes.map(({ at }) => at[axis]));
  const high = Math.max(...boxes.map(({ at, size }) => at[axis] + size[axis]));
  const line = low + share * (high - low);
  return moveCommand(selection, boxes, axis, ({ size }) => Math.round(line - share * size[axis]));
}

/** Distributes the selected nodes evenly; the outermost stay in place. */
export function distributeCommand(
  document: GraphDocument,
  selection: GraphSelection,
  axis: 0 | 1,
  sizeOf: SizeOf,
): Command {
  const boxes = nodeBoxes(document, selection, sizeOf).sort((a, b) => a.at[axis] - b.at[axis]);
  const [first, last] = [boxes[0], boxes.at(-1)];
  if (!first || !last || first === last) return { kind: 'batch', commands: [] };
  const filled = boxes.reduce((sum, { size }) => sum + size[axis], 0);
  const gap = (last.at[axis] + last.size[axis] - first.at[axis] - filled) / (boxes.length - 1);
  let next = first.at[axis];
  return moveCommand(selection, boxes, axis, ({ size }) => {
    const place = next;
    next += size[axis] + gap;
    return Math.round(place);
  });
}

function nodeBoxes(document: GraphDocument, { nodes, group }: GraphSelection, sizeOf: SizeOf): NodeBox[] {
  const layout = graphIn(document, group)?.layout ?? {};
  return nodes.flatMap((node) => {
    const at = own(layout, node);
    return at ? [{ node, at, size: sizeOf(node) }] : [];
  });
}

function moveCommand(
  { group }: GraphSelection,
  boxes: readonly NodeBox[],
  axis: 0 | 1,
  place: (box: NodeBox) => number,
): Command {
  const to = boxes.map((box): [string, CanvasPoint] => {
    const value = place(box);
    return [box.node, axis === 0 ? [value, box.at[1]] : [box.at[0], value]];
  });
  return insideGroup(group, { kind: 'move-nodes', to: Object.fromEntries(to) });
}
