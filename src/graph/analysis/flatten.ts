import { type Message, msg } from '../../messages/message.ts';
import {
  DocumentError,
  type Graph,
  type GraphDocument,
  type GraphEdge,
  type GraphNode,
  MAX_GROUP_DEPTH,
  MAX_NODES,
  own,
} from '../document/document.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupKeyOf, REROUTE } from '../document/structuralTypes.ts';
import type { Registry } from '../nodeType.ts';
import { nodesInCycles } from './cycles.ts';
import { inferTypes } from './inferTypes.ts';
import { type GraphLevel, inputName, levelOf, socketsOf } from './sockets.ts';

/** Source of an input: an output, or none despite a connection. */
export type FlatSource =
  | { readonly kind: 'output'; readonly node: string; readonly output: string }
  | { readonly kind: 'nothing'; readonly why: Message };

export interface FlatNode {
  /** `outer/inner` for a node in a group. */
  readonly id: string;
  readonly type: string;
  readonly params: GraphNode['params'];
  /** By input; for inputs of many edges, in order. Unconnected inputs are absent. */
  readonly inputs: ReadonlyMap<string, readonly FlatSource[]>;
}

export interface FlatAlias {
  readonly output: string;
  readonly source: FlatSource;
}

/** A document without groups, reroutes and muted nodes: what is evaluated. */
export interface FlatGraph {
  readonly nodes: ReadonlyMap<string, FlatNode>;
  /** For nodes removed by flattening: the source of their first output. */
  readonly aliases: ReadonlyMap<string, FlatAlias>;
  /** Nodes in cycles, or between cycles. */
  readonly cycles: ReadonlySet<string>;
}

/** An instance of a level: a group that three nodes use has three. */
interface Scope extends GraphLevel {
  /** `outer/` */
  readonly prefix: string;
  /** The enclosing scope, and the group node in it. */
  readonly parent?: { readonly scope: Scope; readonly node: string };
  readonly inside: Map<string, Scope>;
  readonly incoming: ReadonlyMap<string, readonly GraphEdge[]>;
  /** The group output node. */
  readonly exit?: string;
}

/**
 * Expands the groups of a document and removes pass-through nodes. Throws a DocumentError if the result is too large.
 */
export function flatten(document: GraphDocument, registry: Registry): FlatGraph {
  const nodes = new Map<string, FlatNode>();
  const aliases = new Map<string, FlatAlias>();
  const trace: TraceContext = { registry, cache: new Map() };
  const visit = (scope: Scope): void => {
    for (const [id, node] of Object.entries(scope.graph.nodes)) {
      const flatId = scope.prefix + id;
      if (isPassThrough(node)) aliases.set(flatId, resolveAlias(scope, id, node, trace));
      else
        nodes.set(flatId, {
          id: flatId,
          type: node.type,
          params: node.params,
          inputs: resolveInputs(scope, id, trace),
        });
      const inner = scope.inside.get(id);
      if (inner) visit(inner);
    }
  };
  visit(expandScope({ document, graph: document }, '', undefined, { count: 0 }));
  const before = new Map([...nodes].map(([id, { inputs }]) => [id, sourceNodes([...inputs.values()].flat())]));
  return { nodes, aliases, cycles: nodesInCycles(before) };
}

const sourceNodes = (sources: readonly FlatSource[]): string[] =>
  sources.flatMap((source) => (source.kind === 'output' ? [source.node] : []));

/** Context of tracing back along edges, with a cache. */
interface TraceContext {
  readonly registry: Registry;
  /** Sources of pass-through outputs, by `node.output`. */
  readonly cache: Map<string, FlatSource | undefined>;
}

function resolveAlias(scope: Scope, id: string, node: GraphNode, trace: TraceContext): FlatAlias {
  const output = Object.keys(socketsOf(scope, node, trace.registry)?.outputs ?? {})[0] ?? '';
  const source = resolveSource(scope, { node: id, output }, trace);
  return { output, source: source ?? noSource(msg`nothing is connected to ${scope.prefix}${id}`) };
}

const isPassThrough = (node: GraphNode): boolean =>
  node.muted === true || [GROUP, GROUP_INPUT, GROUP_OUTPUT, REROUTE].includes(node.type);

/** Expands a level with all groups in it; `total` counts the nodes. */
function expandScope(level: GraphLevel, prefix: string, parent: Scope['parent'], total: { count: number }): Scope {
  const depth = prefix.split('/').length - 1;
  if (depth > MAX_GROUP_DEPTH)
    throw new DocumentError(msg`groups.${level.group ?? ''}: groups lie more than ${MAX_GROUP_DEPTH} deep`);
  const entries = Object.entries(level.graph.nodes);
  total.count += entries.length;
  if (total.count > MAX_NODES)
    throw new DocumentError(msg`groups: opened out they make more than ${MAX_NODES} nodes; use them less often`);
  const exit = entries.find(([, { type }]) => type === GROUP_OUTPUT)?.[0];
  const incoming = incomingEdges(level.graph);
  const scope: Scope = { ...level, prefix, parent, inside: new Map(), incoming, exit };
  for (const [id, node] of entries) {
    const inner = node.type === GROUP && !node.muted ? levelOf(level.document, groupKeyOf(node)) : undefined;
    if (inner) scope.inside.set(id, expandScope(inner, `${prefix}${id}/`, { scope, node: id }, total));
  }
  return scope;
}

const incomingEdgesCache = new WeakMap<Graph['edges'], ReadonlyMap<string, readonly GraphEdge[]>>();

/** Incoming edges of each node; those of one socket in order. */
export function incomingEdges({ edges }: Graph): ReadonlyMap<string, readonly GraphEdge[]> {
  const cache = incomingEdgesCache.get(edges);
  if (cache) return cache;
  const found = new Map<string, GraphEdge[]>();
  for (const edge of Object.values(edges)) {
    const list = found.get(edge.to.node);
    if (list) list.push(edge);
    else found.set(edge.to.node, [edge]);
  }
  const order = ({ to }: GraphEdge): number => inputName(to.input).number ?? 0;
  for (const list of found.values()) if (list.length > 1) list.sort((a, b) => order(a) - order(b));
  incomingEdgesCache.set(edges, found);
  return found;
}

function resolveInputs(scope: Scope, id: string, trace: TraceContext): FlatNode['inputs'] {
  const inputs = new Map<string, FlatSource[]>();
  for (const { from, to } of scope.incoming.get(id) ?? []) {
    const source = resolveSource(scope, from, trace);
    if (!source) continue;
    const { base } = inputName(to.input);
    const list = inputs.get(base);
    if (list) list.push(source);
    else inputs.set(base, [source]);
  }
  return inputs;
}

/**
 * Follows an edge back through pass-through nodes to the node that computes; undefined if nothing is connected there.
 */
function resolveSource(start: Scope, edge: GraphEdge['from'], trace: TraceContext): FlatSource | undefined {
  const { cache: known } = trace;
  const passed = new Set<string>();
  let at: OutputLocation = { scope: start, ...edge };
  let found: FlatSource | undefined;
  for (;;) {
    const id = at.scope.prefix + at.node;
    const node = own(at.scope.graph.nodes, at.node);
    if (!node || !isPassThrough(node)) {
      found = node ? { kind: 'output', node: id, output: at.output } : noSource(msg`there is no node ${id}`);
      break;
    }
    const place = `${id}.${at.output}`;
    if (known.has(place) || passed.has(place)) {
      found = passed.has(place) ? noSource(msg`${id} feeds itself; remove one of the edges`) : known.get(place);
      break;
    }
    passed.add(place);
    const before = throughPassThrough(at, node, trace);
    if (!before || 'kind' in before) {
      found = before;
      break;
    }
    at = before;
  }
  for (const place of passed) known.set(place, found);
  return found;
}

const noSource = (why: Message): FlatSource => ({ kind: 'nothing', why });

interface OutputLocation {
  readonly scope: Scope;
  readonly node: string;
  readonly output: string;
}

/** Source of a pass-through node's output. */
function throughPassThrough(
  at: OutputLocation,
  node: GraphNode,
  { registry }: TraceContext,
): OutputLocation | FlatSource | undefined {
  const { scope, output } = at;
  if (node.type === GROUP_INPUT) {
    const { parent } = scope;
    return parent ? edgeSource(parent.scope, parent.node, output) : noSource(msg`${at.node} stands in no group`);
  }
  if (node.muted) return throughMuted(at, node, registry);
  if (node.type === REROUTE) return edgeSource(scope, at.node, 'in');
  const inner = scope.inside.get(at.node);
  const group = scope.prefix + at.node;
  if (!inner) return noSource(msg`there is no group "${groupKeyOf(node)}"`);
  if (inner.exit === undefined) return noSource(msg`the group ${group} has no group output`);
  return (
    edgeSource(inner, inner.exit, output) ?? noSource(msg`in the group ${group} nothing is connected to ${output}`)
  );
}

function edgeSource(scope: Scope, node: string, input: string): OutputLocation | undefined {
  const edge = own(scope.graph.edges, `${node}.${input}`);
  return edge && { scope, ...edge.from };
}

/** A muted node passes to each output the first connected input of the same type. */
function throughMuted(
  { scope, node: id, output }: OutputLocation,
  node: GraphNode,
  registry: Registry,
): OutputLocation | FlatSource {
  const types = inferTypes(scope, registry);
  const wanted = types.typeOf(id, 'outputs', output);
  const order = Object.keys(socketsOf(scope, node, registry)?.inputs ?? {});
  const [first] = [...(scope.incoming.get(id) ?? [])]
    .filter(({ to }) => types.typeOf(id, 'inputs', to.input) === wanted)
    .sort((a, b) => order.indexOf(inputName(a.to.input).base) - order.indexOf(inputName(b.to.input).base));
  if (first) return { scope, ...first.from };
  return noSource(msg`${scope.prefix}${id} is muted and has no ${wanted ?? output} to pass on; unmute it`);
}
