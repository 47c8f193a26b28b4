import type { Graph, GraphEdge } from '../../../graph/document/document.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { boundingRect, type CanvasRect } from '../cards/cardGeometry.ts';

/** Gaps between columns, and between nodes of a column [px]. */
const COLUMN_GAP = 90;
const ROW_GAP = 28;
const SWEEPS = 6;

type Edges = readonly GraphEdge[];

/**
 * Layered layout with data flowing from left to right: each node is in the column after its last source, as near as
 * possible to its targets; within a column nodes are ordered by the barycenter of their neighbours (Sugiyama, Tagawa
 * and Toda 1981). The top left corner is at the origin.
 */
export function layeredLayout(
  nodes: readonly string[],
  edges: Edges,
  sizeOf: (node: string) => CanvasPoint,
): Readonly<Record<string, CanvasPoint>> {
  const inner = edgesAmong(nodes, edges);
  const columns = columnsOf(nodes, inner);
  const ordered = orderByBarycenter(columns, inner);
  return assignPositions(ordered, inner, sizeOf);
}

function edgesAmong(nodes: readonly string[], edges: Edges): Edges {
  const known = new Set(nodes);
  return edges.filter(({ from, to }) => from.node !== to.node && known.has(from.node) && known.has(to.node));
}

type Adjacency = ReadonlyMap<string, readonly string[]>;

function adjacency(edges: Edges, of: 'from' | 'to'): Adjacency {
  const found = new Map<string, string[]>();
  for (const edge of edges) {
    const list = found.get(edge[of].node) ?? [];
    list.push(edge[of === 'from' ? 'to' : 'from'].node);
    found.set(edge[of].node, list);
  }
  return found;
}

/** Nodes by column. Nodes of a cycle are placed in order of first visit. */
function columnsOf(nodes: readonly string[], edges: Edges): string[][] {
  const feeding = adjacency(edges, 'to');
  const fed = adjacency(edges, 'from');
  const ranks = new Map<string, number>();
  for (const id of flowOrder(nodes, fed, feeding))
    ranks.set(id, Math.max(-1, ...(feeding.get(id) ?? []).map((before) => ranks.get(before) ?? -1)) + 1);
  // Nodes without sources go right before their targets, not to the first column.
  for (const id of nodes) {
    if (feeding.has(id)) continue;
    const after = (fed.get(id) ?? []).map((next) => ranks.get(next)!);
    if (after.length > 0) ranks.set(id, Math.max(0, Math.min(...after) - 1));
  }
  const columns = Array.from({ length: Math.max(-1, ...ranks.values()) + 1 }, (): string[] => []);
  for (const id of nodes) columns[ranks.get(id)!]!.push(id);
  return columns.filter((column) => column.length > 0);
}

/** Topological order (Kahn 1962); nodes of cycles follow. */
function flowOrder(nodes: readonly string[], fed: Adjacency, feeding: Adjacency): ReadonlySet<string> {
  const waiting = new Map(nodes.map((id) => [id, feeding.get(id)?.length ?? 0]));
  const order = new Set(nodes.filter((id) => waiting.get(id) === 0));
  for (const id of order) {
    for (const next of fed.get(id) ?? []) {
      const left = waiting.get(next)! - 1;
      waiting.set(next, left);
      if (left === 0) order.add(next);
    }
  }
  for (const id of nodes) order.add(id);
  return order;
}

/** Orders each column by the mean position of its neighbours in the previous column, then in the next, alternately. */
function orderByBarycenter(columns: readonly string[][], edges: Edges): string[][] {
  const [before, after] = [adjacency(edges, 'to'), adjacency(edges, 'from')];
  const ordered = columns.map((column) => [...column]);
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    const forth = sweep % 2 === 0;
    const places = new Map(ordered.flatMap((column) => column.map((id, i) => [id, i / column.length] as const)));
    for (const column of forth ? ordered : [...ordered].reverse()) {
      const wanted = new Map(column.map((id) => [id, barycenter(forth ? before : after, id, places)]));
      column.sort((a, b) => wanted.get(a)! - wanted.get(b)!);
      column.forEach((id, i) => {
        places.set(id, i / column.length);
      });
    }
  }
  return ordered;
}

function barycenter(of: Adjacency, id: string, places: ReadonlyMap<string, number>): number {
  const around = of.get(id) ?? [];
  if (around.length === 0) return places.get(id)!;
  return around.reduce((sum, other) => sum + places.get(other)!, 0) / around.length;
}

/**
 * Positions columns from left to right; each node is as near as possible to the center of its sources, keeping the
 * column's order.
 */
function assignPositions(columns: readonly string[][], edges: Edges, sizeOf: (node: string) => CanvasPoint) {
  const feeding = adjacency(edges, 'to');
  const tops = new Map<string, number>();
  const lefts = new Map<string, number>();
  const middle = (id: string): number => tops.get(id)! + sizeOf(id)[1] / 2;
  let left = 0;
  for (const column of columns) {
    const wanted = column.map((id) => {
      const known = (feeding.get(id) ?? []).filter((before) => tops.has(before));
      if (known.length === 0) return undefined;
      return known.reduce((sum, before) => sum + middle(before), 0) / known.length - sizeOf(id)[1] / 2;
    });
    stackColumn(column, wanted, sizeOf).forEach((top, i) => {
      tops.set(column[i]!, top);
      lefts.set(column[i]!, left);
    });
    left += Math.max(...column.map((id) => sizeOf(id)[0])) + COLUMN_GAP;
  }
  const highest = Math.min(0, ...tops.values());
  const entries = [...tops].map(([id, top]): [string, CanvasPoint] => [
    id,
    [Math.round(lefts.get(id)!), Math.round(top - highest)],
  ]);
  return Object.fromEntries(entries);
}

/** Tops of a column's nodes, stacked, and shifted together by the mean offset from their wanted positions. */
function stackColumn(
  column: readonly string[],
  wanted: readonly (number | undefined)[],
  sizeOf: (node: string) => CanvasPoint,
): number[] {
  const tops: number[] = [];
  let next = Number.NEGATIVE_INFINITY;
  column.forEach((id, i) => {
    const top = Math.max(wanted[i] ?? (i === 0 ? 0 : next), next === Number.NEGATIVE_INFINITY ? -1e9 : next);
    tops.push(top);
    next = top + sizeOf(id)[1] + ROW_GAP;
  });
  const shifts = tops.flatMap((top, i) => (wanted[i] === undefined ? [] : [wanted[i] - top]));
  const shift = shifts.length === 0 ? 0 : shifts.reduce((sum, each) => sum + each, 0) / shifts.length;
  return tops.map((top) => top + shift);
}

/** Positions of a level's nodes: from the document; nodes without one are laid out below. */
export function nodePositions(
  graph: Graph,
  sizeOf: (node: string) => CanvasPoint,
): Readonly<Record<string, CanvasPoint>> {
  const lost = Object.keys(graph.nodes).filter((id) => !Object.hasOwn(graph.layout, id));
  if (lost.length === 0) return graph.layout;
  const kept = boundingRect(Object.entries(graph.layout).map(([id, at]): CanvasRect => ({ at, size: sizeOf(id) })));
  const [x, y] = kept ? [kept.at[0], kept.at[1] + kept.size[1] + 2 * COLUMN_GAP] : [0, 0];
  const found = layeredLayout(lost, Object.values(graph.edges), sizeOf);
  const moved = Object.entries(found).map(([id, at]): [string, CanvasPoint] => [id, [at[0] + x, at[1] + y]]);
  return { ...graph.layout, ...Object.fromEntries(moved) };
}
