import {
  edgeKey,
  type Graph,
  type GraphEdge,
  type GraphFrame,
  type GraphNode,
  type GraphNote,
} from '../document/document.ts';
import type { CanvasPoint } from './commands.ts';

/** New keys of a graph's items. */
export interface KeyMapping {
  readonly node: (key: string) => string;
  readonly note: (key: string) => string;
  readonly frame: (key: string) => string;
}

/** The same graph with other keys, moved by `shift`. */
export function rekeyGraph(graph: Graph, { node, note, frame }: KeyMapping, [dx, dy]: CanvasPoint): Graph {
  const moved = ([x, y]: CanvasPoint): [number, number] => [x + dx, y + dy];
  const edges = Object.values(graph.edges).map(
    ({ from, to }): GraphEdge => ({
      from: { node: node(from.node), output: from.output },
      to: { node: node(to.node), input: to.input },
    }),
  );
  return {
    nodes: table(graph.nodes, node, (held: GraphNode) => held),
    edges: Object.fromEntries(edges.map((edge) => [edgeKey(edge.to), edge])),
    layout: table(graph.layout, node, moved),
    notes: table(graph.notes, note, (held: GraphNote) => ({ ...held, at: moved(held.at) })),
    frames: table(graph.frames, frame, (held: GraphFrame) => ({ ...held, nodes: held.nodes.map(node) })),
  };
}

const table = <From, To>(
  held: Readonly<Record<string, From>>,
  key: (key: string) => string,
  value: (held: From) => To,
) => Object.fromEntries(Object.entries(held).map(([name, item]): [string, To] => [key(name), value(item)]));

/** The part of a level that belongs to some nodes: edges between them, positions, and frames around only these. */
export function subgraphOf(graph: Graph, nodes: ReadonlySet<string>, notes: ReadonlySet<string> = new Set()): Graph {
  const within = <T>(held: Readonly<Record<string, T>>, keep: (key: string, item: T) => boolean) =>
    Object.fromEntries(Object.entries(held).filter(([key, item]) => keep(key, item)));
  return {
    nodes: within(graph.nodes, (key) => nodes.has(key)),
    edges: within(graph.edges, (_key, { from, to }) => nodes.has(from.node) && nodes.has(to.node)),
    layout: within(graph.layout, (key) => nodes.has(key)),
    notes: within(graph.notes, (key) => notes.has(key)),
    frames: within(graph.frames, (_key, frame) => frame.nodes.every((id) => nodes.has(id))),
  };
}

/** Center of positions; [0, 0] for none. */
export function layoutCenter(places: readonly CanvasPoint[]): CanvasPoint {
  const mean = (axis: 0 | 1): number => {
    const values = places.map((place) => place[axis]);
    return values.length === 0 ? 0 : Math.round((Math.min(...values) + Math.max(...values)) / 2);
  };
  return [mean(0), mean(1)];
}
