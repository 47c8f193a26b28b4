import type { Point } from '../../graph/commands.ts';
import type { Level } from '../../graph/sockets.ts';
import { canvas } from './canvas.ts';
import { freePlace, NODE_WIDTH } from './shape.ts';

/** Of a node of which is not known yet what it shows. */
const USUAL: Point = [NODE_WIDTH, 110];

/** Where a new node covers none of those that are there. */
export function freePlaceIn({ graph }: Level, wanted: Point): Point {
  const { sight } = canvas.getState();
  if (!sight) return wanted;
  const boxes = Object.keys(graph.nodes).map((id) => ({ at: sight.placeOf(id), size: sight.sizeOf(id) }));
  return freePlace(wanted, USUAL, boxes);
}
