import { circlesIn } from './circles.ts';
import {
  DEEPEST_GROUP,
  DocumentError,
  type Graph,
  type GraphDocument,
  type GraphEdge,
  type GraphNode,
  MOST_NODES,
  own,
} from './document.ts';
import { typesIn } from './infer.ts';
import type { Registry } from './nodeType.ts';
import { inputName, type Level, levelOf, socketsOf } from './sockets.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupOf, REROUTE } from './structure.ts';

/** What feeds an input: an output, or nothing although something is connected. */
export type FlatSource =
  | { readonly kind: 'output'; readonly node: string; readonly output: string }
  | { readonly kind: 'nothing'; readonly why: string };

export interface FlatNode {
  /** `outer/inner` of a node in a group. */
  readonly id: string;
  readonly type: string;
  readonly params: GraphNode['params'];
  /** By input; of one that takes many, in order. What is not connected is not here. */
  readonly inputs: ReadonlyMap<string, readonly FlatSource[]>;
}

export interface FlatAlias {
  readonly output: string;
  readonly source: FlatSource;
}

/** A document without groups, bends and muted nodes: what is evaluated. */
export interface FlatGraph {
  readonly nodes: ReadonlyMap<string, FlatNode>;
  /** For nodes that flattening took out: what their first output was. */
  readonly aliases: ReadonlyMap<string, FlatAlias>;
  /** Nodes that feed themselves, or lie between such. */
  readonly circles: ReadonlySet<string>;
}

/** A level in place: a group that three nodes use is there three times. */
interface Scope extends Level {
  /** `outer/` */
  readonly prefix: string;
  /** The level around it, and its node there. */
  readonly parent?: { readonly scope: Scope; readonly node: string };
  readonly inside: Map<string, Scope>;
  readonly incoming: ReadonlyMap<string, readonly GraphEdge[]>;
  /** The node that carries the group's outputs. */
  readonly exit?: string;
}

/** Opens out the groups of a document and takes out what computes nothing. Throws a DocumentError where that gives too much. */
export function flatten(document: GraphDocument, registry: Registry): FlatGraph {
  const nodes = new Map<string, FlatNode>();
  const aliases = new Map<string, FlatAlias>();
  const walk: Walk = { registry, known: new Map() };
  const visit = (scope: Scope): void => {
    for (const [id, node] of Object.entries(scope.graph.nodes)) {
      const flatId = scope.prefix + id;
      if (isPassage(node)) aliases.set(flatId, aliasOf(scope, id, node, walk));
      else nodes.set(flatId, { id: flatId, type: node.type, params: node.params, inputs: inputsOf(scope, id, walk) });
      const inner = scope.inside.get(id);
      if (inner) visit(inner);
    }
  };
  visit(openedOut({ document, graph: document }, '', undefined, { count: 0 }));
  const before = new Map([...nodes].map(([id, { inputs }]) => [id, nodesOf([...inputs.values()].flat())]));
  return { nodes, aliases, circles: circlesIn(before) };
}

const nodesOf = (sources: readonly FlatSource[]): string[] =>
  sources.flatMap((source) => (source.kind === 'output' ? [source.node] : []));

/** What is needed on the way back along edges, and what has been found on it. */
interface Walk {
  readonly registry: Registry;
  /** By `node.output` of what passes on. */
  readonly known: Map<string, FlatSource | undefined>;
}

function aliasOf(scope: Scope, id: string, node: GraphNode, walk: Walk): FlatAlias {
  const output = Object.keys(socketsOf(scope, node, walk.registry)?.outputs ?? {})[0] ?? '';
  const source = sourceOf(scope, { node: id, output }, walk);
  return { output, source: source ?? nothing(`nothing is connected to ${scope.prefix}${id}`) };
}

const isPassage = (node: GraphNode): boolean =>
  node.muted === true || [GROUP, GROUP_INPUT, GROUP_OUTPUT, REROUTE].includes(node.type);

/** A level with all groups in it; `total` counts what that makes. */
function openedOut(level: Level, prefix: string, parent: Scope['parent'], total: { count: number }): Scope {
  const depth = prefix.split('/').length - 1;
  if (depth > DEEPEST_GROUP)
    throw new DocumentError(`groups.${level.group}: groups lie more than ${DEEPEST_GROUP} deep`);
  const entries = Object.entries(level.graph.nodes);
  total.count += entries.length;
  if (total.count > MOST_NODES)
    throw new DocumentError(`groups: opened out they make more than ${MOST_NODES} nodes; use them less often`);
  const exit = entries.find(([, { type }]) => type === GROUP_OUTPUT)?.[0];
  const incoming = edgesInto(level.graph);
  const scope: Scope = { ...level, prefix, parent, inside: new Map(), incoming, exit };
  for (const [id, node] of entries) {
    const inner = node.type === GROUP && !node.muted ? levelOf(level.document, groupOf(node)) : undefined;
    if (inner) scope.inside.set(id, openedOut(inner, `${prefix}${id}/`, { scope, node: id }, total));
  }
  return scope;
}

const intoNodes = new WeakMap<Graph['edges'], ReadonlyMap<string, readonly GraphEdge[]>>();

/** The edges that feed each node, those into one socket in their order. */
export function edgesInto({ edges }: Graph): ReadonlyMap<string, readonly GraphEdge[]> {
  const known = intoNodes.get(edges);
  if (known) return known;
  const found = new Map<string, GraphEdge[]>();
  for (const edge of Object.values(edges)) {
    const list = found.get(edge.to.node);
    if (list) list.push(edge);
    else found.set(edge.to.node, [edge]);
  }
  const order = ({ to }: GraphEdge): number => inputName(to.input).number ?? 0;
  for (const list of found.values()) if (list.length > 1) list.sort((a, b) => order(a) - order(b));
  intoNodes.set(edges, found);
  return found;
}

function inputsOf(scope: Scope, id: string, walk: Walk): FlatNode['inputs'] {
  const inputs = new Map<string, FlatSource[]>();
  for (const { from, to } of scope.incoming.get(id) ?? []) {
    const source = sourceOf(scope, from, walk);
    if (!source) continue;
    const { base } = inputName(to.input);
    const list = inputs.get(base);
    if (list) list.push(source);
    else inputs.set(base, [source]);
  }
  return inputs;
}

/** Follows an edge back through all that passes on, to the node that computes; undefined where nothing is connected there. */
function sourceOf(start: Scope, edge: GraphEdge['from'], walk: Walk): FlatSource | undefined {
  const { known } = walk;
  const passed = new Set<string>();
  let at: Place = { scope: start, ...edge };
  let found: FlatSource | undefined;
  for (;;) {
    const id = at.scope.prefix + at.node;
    const node = own(at.scope.graph.nodes, at.node);
    if (!node || !isPassage(node)) {
      found = node ? { kind: 'output', node: id, output: at.output } : nothing(`there is no node ${id}`);
      break;
    }
    const place = `${id}.${at.output}`;
    if (known.has(place) || passed.has(place)) {
      found = passed.has(place) ? nothing(`${id} feeds itself; remove one of the edges`) : known.get(place);
      break;
    }
    passed.add(place);
    const before = throughPassage(at, node, walk);
    if (!before || 'kind' in before) {
      found = before;
      break;
    }
    at = before;
  }
  for (const place of passed) known.set(place, found);
  return found;
}

const nothing = (why: string): FlatSource => ({ kind: 'nothing', why });

interface Place {
  readonly scope: Scope;
  readonly node: string;
  readonly output: string;
}

/** What a node that computes nothing passes on at an output. */
function throughPassage(at: Place, node: GraphNode, { registry }: Walk): Place | FlatSource | undefined {
  const { scope, output } = at;
  if (node.type === GROUP_INPUT) {
    const { parent } = scope;
    return parent ? edgeTo(parent.scope, parent.node, output) : nothing(`${at.node} stands in no group`);
  }
  if (node.muted) return throughMuted(at, node, registry);
  if (node.type === REROUTE) return edgeTo(scope, at.node, 'in');
  const inner = scope.inside.get(at.node);
  const group = scope.prefix + at.node;
  if (!inner) return nothing(`there is no group "${groupOf(node)}"`);
  if (inner.exit === undefined) return nothing(`the group ${group} has no group output`);
  return edgeTo(inner, inner.exit, output) ?? nothing(`in the group ${group} nothing is connected to ${output}`);
}

function edgeTo(scope: Scope, node: string, input: string): Place | undefined {
  const edge = own(scope.graph.edges, `${node}.${input}`);
  return edge && { scope, ...edge.from };
}

/** A muted node passes to each output the first connected input of its type. */
function throughMuted({ scope, node: id, output }: Place, node: GraphNode, registry: Registry): Place | FlatSource {
  const types = typesIn(scope, registry);
  const wanted = types.typeOf(id, 'outputs', output);
  const order = Object.keys(socketsOf(scope, node, registry)?.inputs ?? {});
  const [first] = [...(scope.incoming.get(id) ?? [])]
    .filter(({ to }) => types.typeOf(id, 'inputs', to.input) === wanted)
    .sort((a, b) => order.indexOf(inputName(a.to.input).base) - order.indexOf(inputName(b.to.input).base));
  if (first) return { scope, ...first.from };
  return nothing(`${scope.prefix}${id} is muted and has no ${wanted ?? output} to pass on; unmute it`);
}
