import { msg } from '../../messages/message.ts';
import { inferTypes } from '../analysis/inferTypes.ts';
import { type GraphLevel, inputName, levelOf } from '../analysis/sockets.ts';
import { reachableFrom } from '../analysis/validate.ts';
import {
  edgeKey,
  type Graph,
  type GraphDocument,
  type GraphEdge,
  type GroupSocket,
  type NodeGroup,
  own,
} from '../document/document.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT } from '../document/structuralTypes.ts';
import { ANY, type Registry } from '../nodeType.ts';
import { type CanvasPoint, type Command, CommandError } from './commands.ts';
import { type GraphSelection, insideGroup } from './fragment.ts';
import { FreshKeys } from './freshKeys.ts';
import { layoutCenter, subgraphOf } from './subgraph.ts';

/** Distance from a group's nodes to its input and output nodes [px]. */
const BOUNDARY_MARGIN = 260;

export interface Grouping {
  readonly command: Command;
  /** The group node that replaces the selection. */
  readonly node: string;
  readonly group: string;
}

/** Groups nodes of a level, replaces them by an instance and preserves connections. */
export function groupCommand(
  document: GraphDocument,
  { nodes, group: parentGroup }: GraphSelection,
  title: string,
  registry: Registry,
): Grouping {
  const level = levelOf(document, parentGroup);
  if (!level) throw new CommandError(msg`there is no group "${parentGroup ?? ''}"`);
  const chosen = new Set(nodes);
  assertGroupable(level, chosen);
  const cut = extractGroup(level, chosen, registry);
  const node = new FreshKeys(level.graph.nodes).next('group');
  const group = new FreshKeys(document.groups).next('group');
  const at = layoutCenter(Object.values(cut.group.layout));
  const here: Command[] = [
    { kind: 'remove-nodes', nodes: [...chosen] },
    { kind: 'add-node', node, type: GROUP, at, params: { group } },
    ...cut.into.map(({ from, name }) => connect(from, { node, input: name })),
    ...cut.outOf.map(({ to, name }) => connect({ node, output: name }, to)),
  ];
  const commands: Command[] = [
    { kind: 'set-group', group, value: { ...cut.group, title } },
    insideGroup(parentGroup, { kind: 'batch', commands: here }),
  ];
  return { command: { kind: 'batch', commands }, node, group };
}

const connect = (from: GraphEdge['from'], to: GraphEdge['to']): Command => ({ kind: 'connect', edge: { from, to } });

function assertGroupable({ graph }: GraphLevel, chosen: ReadonlySet<string>): void {
  if (chosen.size === 0) throw new CommandError(msg`choose the nodes that the group is to hold`);
  for (const id of chosen) {
    const node = own(graph.nodes, id);
    if (!node) throw new CommandError(msg`there is no node "${id}"`);
    if (node.type === GROUP_INPUT || node.type === GROUP_OUTPUT)
      throw new CommandError(msg`${id} carries the sockets of the group around it, and stays there`);
  }
  // Nodes outside that are both fed by the selection and feed it.
  const edges = Object.values(graph.edges);
  const outer = subgraphOf(graph, new Set(Object.keys(graph.nodes).filter((id) => !chosen.has(id))));
  const fed = new Set(
    edges.flatMap(({ from, to }) => (chosen.has(from.node) && !chosen.has(to.node) ? [to.node] : [])),
  );
  const feeding = edges.flatMap(({ from, to }) => (chosen.has(to.node) && !chosen.has(from.node) ? [from.node] : []));
  const reached = reachableFrom(outer, fed);
  const through = feeding.find((id) => reached.has(id));
  if (through !== undefined)
    throw new CommandError(msg`the group would feed itself over ${through}; take that into it too, or less`);
}

/** The content of the new group, and the edges that its node takes over. */
interface GroupBoundary {
  readonly group: Omit<NodeGroup, 'title'>;
  readonly into: readonly { readonly from: GraphEdge['from']; readonly name: string }[];
  readonly outOf: readonly { readonly to: GraphEdge['to']; readonly name: string }[];
}

function extractGroup(level: GraphLevel, chosen: ReadonlySet<string>, registry: Registry): GroupBoundary {
  const part = subgraphOf(level.graph, chosen);
  const carriers = new FreshKeys(part.nodes);
  const [entry, exit] = [carriers.next('input'), carriers.next('output')];
  const types = inferTypes(level, registry);
  const edges = Object.values(level.graph.edges);
  const inward = edges.filter(({ from, to }) => chosen.has(to.node) && !chosen.has(from.node));
  const outward = edges.filter(({ from, to }) => chosen.has(from.node) && !chosen.has(to.node));
  const typeOf = ({ node, output }: GraphEdge['from']): string => types.typeOf(node, 'outputs', output) ?? ANY;
  // One socket per cut output, however many inputs it feeds.
  const inputs = boundarySockets(inward, typeOf, ({ to }) => inputName(to.input).base);
  const outputs = boundarySockets(outward, typeOf, ({ from }) => from.output);
  const inner = [
    ...inward.map(({ from, to }) => ({ from: { node: entry, output: inputs.nameOf(from) }, to })),
    ...outputs.sources.map(({ from, name }) => ({ from, to: { node: exit, input: name } })),
  ];
  return {
    group: { ...withBoundaryNodes(part, entry, exit, inner), inputs: inputs.sockets, outputs: outputs.sockets },
    into: inputs.sources,
    outOf: outward.map(({ from, to }) => ({ to, name: outputs.nameOf(from) })),
  };
}

function withBoundaryNodes(part: Graph, entry: string, exit: string, inner: readonly GraphEdge[]): Graph {
  const places = Object.values(part.layout);
  const [, y] = layoutCenter(places);
  const [left, right] = places.length === 0 ? [0, 0] : extent(places.map(([x]) => x));
  return {
    ...part,
    nodes: { ...part.nodes, [entry]: { type: GROUP_INPUT, params: {} }, [exit]: { type: GROUP_OUTPUT, params: {} } },
    layout: { ...part.layout, [entry]: [left - BOUNDARY_MARGIN, y], [exit]: [right + BOUNDARY_MARGIN, y] },
    edges: { ...part.edges, ...Object.fromEntries(inner.map((edge) => [edgeKey(edge.to), edge])) },
  };
}

const extent = (values: readonly number[]): CanvasPoint => [Math.min(...values), Math.max(...values)];

function boundarySockets(
  edges: readonly GraphEdge[],
  typeOf: (from: GraphEdge['from']) => string,
  wanted: (edge: GraphEdge) => string,
) {
  const fresh = new FreshKeys();
  const found = new Map<string, { readonly from: GraphEdge['from']; readonly name: string }>();
  const key = ({ node, output }: GraphEdge['from']): string => `${node}.${output}`;
  for (const edge of edges)
    if (!found.has(key(edge.from))) found.set(key(edge.from), { from: edge.from, name: fresh.next(wanted(edge)) });
  const sources = [...found.values()];
  return {
    sources,
    sockets: sources.map(({ from, name }): GroupSocket => ({ name, type: typeOf(from) })),
    nameOf: (from: GraphEdge['from']): string => found.get(key(from))!.name,
  };
}
