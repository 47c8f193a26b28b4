import { type Command, CommandError, type Point } from '../commands.ts';
import {
  edgeKey,
  type Graph,
  type GraphDocument,
  type GraphEdge,
  type Group,
  type GroupSocket,
  own,
} from '../document.ts';
import { typesIn } from '../infer.ts';
import { ANY, type Registry } from '../nodeType.ts';
import { inputName, type Level, levelOf } from '../sockets.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT } from '../structure.ts';
import { reachedFrom } from '../validate.ts';
import { inside, type Selection } from './fragment.ts';
import { FreshKeys } from './fresh.ts';
import { middleOf, partOf } from './renamed.ts';

/** From a group's own nodes to those that carry its inputs and outputs [px]. */
const MARGIN = 260;

export interface Grouping {
  readonly command: Command;
  /** The node that stands for the selection now. */
  readonly node: string;
  readonly group: string;
}

/** Makes some nodes of a level a group, with a node of it in their place; what was connected to them stays so. */
export function groupingOf(
  document: GraphDocument,
  { nodes, group: around }: Selection,
  title: string,
  registry: Registry,
): Grouping {
  const level = levelOf(document, around);
  if (!level) throw new CommandError(`there is no group "${around}"`);
  const chosen = new Set(nodes);
  refuseGrouping(level, chosen);
  const cut = cutOut(level, chosen, registry);
  const node = new FreshKeys(level.graph.nodes).take('group');
  const group = new FreshKeys(document.groups).take('group');
  const at = middleOf(Object.values(cut.group.layout));
  const here: Command[] = [
    { kind: 'remove-nodes', nodes: [...chosen] },
    { kind: 'add-node', node, type: GROUP, at, params: { group } },
    ...cut.into.map(({ from, name }) => connect(from, { node, input: name })),
    ...cut.outOf.map(({ to, name }) => connect({ node, output: name }, to)),
  ];
  const commands: Command[] = [
    { kind: 'set-group', group, value: { ...cut.group, title } },
    inside(around, { kind: 'batch', commands: here }),
  ];
  return { command: { kind: 'batch', commands }, node, group };
}

const connect = (from: GraphEdge['from'], to: GraphEdge['to']): Command => ({ kind: 'connect', edge: { from, to } });

function refuseGrouping({ graph }: Level, chosen: ReadonlySet<string>): void {
  if (chosen.size === 0) throw new CommandError('choose the nodes that the group is to hold');
  for (const id of chosen) {
    const node = own(graph.nodes, id);
    if (!node) throw new CommandError(`there is no node "${id}"`);
    if (node.type === GROUP_INPUT || node.type === GROUP_OUTPUT)
      throw new CommandError(`${id} carries the sockets of the group around it, and stays there`);
  }
  // Outside, from what the selection feeds back to what feeds it.
  const edges = Object.values(graph.edges);
  const outer = partOf(graph, new Set(Object.keys(graph.nodes).filter((id) => !chosen.has(id))));
  const fed = new Set(
    edges.flatMap(({ from, to }) => (chosen.has(from.node) && !chosen.has(to.node) ? [to.node] : [])),
  );
  const feeding = edges.flatMap(({ from, to }) => (chosen.has(to.node) && !chosen.has(from.node) ? [from.node] : []));
  const reached = reachedFrom(outer, fed);
  const through = feeding.find((id) => reached.has(id));
  if (through !== undefined)
    throw new CommandError(`the group would feed itself over ${through}; take that into it too, or less`);
}

/** The inside of the group to be, and the edges that its node takes over. */
interface Cut {
  readonly group: Omit<Group, 'title'>;
  readonly into: readonly { readonly from: GraphEdge['from']; readonly name: string }[];
  readonly outOf: readonly { readonly to: GraphEdge['to']; readonly name: string }[];
}

function cutOut(level: Level, chosen: ReadonlySet<string>, registry: Registry): Cut {
  const part = partOf(level.graph, chosen);
  const carriers = new FreshKeys(part.nodes);
  const [entry, exit] = [carriers.take('input'), carriers.take('output')];
  const types = typesIn(level, registry);
  const edges = Object.values(level.graph.edges);
  const inward = edges.filter(({ from, to }) => chosen.has(to.node) && !chosen.has(from.node));
  const outward = edges.filter(({ from, to }) => chosen.has(from.node) && !chosen.has(to.node));
  const typeOf = ({ node, output }: GraphEdge['from']): string => types.typeOf(node, 'outputs', output) ?? ANY;
  // One socket for each output that is cut off from an input, however many inputs it feeds.
  const inputs = socketsFor(inward, typeOf, ({ to }) => inputName(to.input).base);
  const outputs = socketsFor(outward, typeOf, ({ from }) => from.output);
  const inner = [
    ...inward.map(({ from, to }) => ({ from: { node: entry, output: inputs.nameOf(from) }, to })),
    ...outputs.sources.map(({ from, name }) => ({ from, to: { node: exit, input: name } })),
  ];
  return {
    group: { ...withCarriers(part, entry, exit, inner), inputs: inputs.sockets, outputs: outputs.sockets },
    into: inputs.sources,
    outOf: outward.map(({ from, to }) => ({ to, name: outputs.nameOf(from) })),
  };
}

function withCarriers(part: Graph, entry: string, exit: string, inner: readonly GraphEdge[]): Graph {
  const places = Object.values(part.layout);
  const [, y] = middleOf(places);
  const [left, right] = places.length === 0 ? [0, 0] : extent(places.map(([x]) => x));
  return {
    ...part,
    nodes: { ...part.nodes, [entry]: { type: GROUP_INPUT, params: {} }, [exit]: { type: GROUP_OUTPUT, params: {} } },
    layout: { ...part.layout, [entry]: [left - MARGIN, y], [exit]: [right + MARGIN, y] },
    edges: { ...part.edges, ...Object.fromEntries(inner.map((edge) => [edgeKey(edge.to), edge])) },
  };
}

const extent = (values: readonly number[]): Point => [Math.min(...values), Math.max(...values)];

function socketsFor(
  edges: readonly GraphEdge[],
  typeOf: (from: GraphEdge['from']) => string,
  wanted: (edge: GraphEdge) => string,
) {
  const fresh = new FreshKeys();
  const found = new Map<string, { readonly from: GraphEdge['from']; readonly name: string }>();
  const key = ({ node, output }: GraphEdge['from']): string => `${node}.${output}`;
  for (const edge of edges)
    if (!found.has(key(edge.from))) found.set(key(edge.from), { from: edge.from, name: fresh.take(wanted(edge)) });
  const sources = [...found.values()];
  return {
    sources,
    sockets: sources.map(({ from, name }): GroupSocket => ({ name, type: typeOf(from) })),
    nameOf: (from: GraphEdge['from']): string => found.get(key(from))!.name,
  };
}
