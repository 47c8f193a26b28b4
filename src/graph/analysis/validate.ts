import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import {
  DocumentError,
  edgeKey,
  type GraphDocument,
  type GraphEdge,
  type GraphNode,
  own,
} from '../document/document.ts';
import { findFault } from '../document/integrity.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupKeyOf } from '../document/structuralTypes.ts';
import { type NodeProblem, type NodeType, type Registry, resolveParams, valueError } from '../nodeType.ts';
import { nodesInCycles } from './cycles.ts';
import { flatten, incomingEdges } from './flatten.ts';
import { inferTypes } from './inferTypes.ts';
import { type GraphLevel, inputName, inputSocket, levelOf, levelsOf, socketsOf } from './sockets.ts';

/**
 * All problems of a document, each at its node (`group/node` in a group's definition).
 * @example
 * import { newProject, nodeLibrary } from 'slowlight/nodes';
 * const { document } = applyCommand(newProject('street.usda'), { kind: 'remove-nodes', nodes: ['camera'] });
 * const [problem] = validateDocument(document, nodeLibrary);
 * problem.severity; // 'error'
 */
export function validateDocument(document: GraphDocument, registry: Registry): NodeProblem[] {
  const fault = findFault(document) ?? findFlattenFault(document, registry);
  if (fault) return [problemAt('graph.document', msg`the project`, fault)];
  return levelsOf(document).flatMap((level) => checkLevel(level, registry));
}

function findFlattenFault(document: GraphDocument, registry: Registry): Message | undefined {
  try {
    flatten(document, registry);
    return undefined;
  } catch (thrown) {
    if (thrown instanceof DocumentError) return thrown.text;
    throw thrown;
  }
}

function checkLevel(level: GraphLevel, registry: Registry): NodeProblem[] {
  const place = (id: string) => (level.group === undefined ? id : `${level.group}/${id}`);
  const connected = new Set(Object.values(level.graph.edges).map(({ to }) => `${to.node}.${inputName(to.input).base}`));
  const problems = Object.entries(level.graph.nodes).flatMap(([id, node]) =>
    checkNode(level, node, registry, place(id), (input) => connected.has(`${id}.${input}`)),
  );
  for (const edge of Object.values(level.graph.edges)) {
    const refusal = socketError(level, edge, registry);
    if (refusal) problems.push(problemAt('graph.edge', place(edge.to.node), refusal));
  }
  for (const { edge, message } of inferTypes(level, registry).conflicts)
    problems.push(problemAt('graph.edge', place(edge.to.node), message));
  for (const id of levelCycles(level)) problems.push(problemAt('graph.cycle', place(id), CYCLE_MESSAGE));
  return problems;
}

export const CYCLE_MESSAGE = msg`the node feeds itself: remove one of the edges`;

function checkNode(
  level: GraphLevel,
  node: GraphNode,
  registry: Registry,
  place: string,
  isConnected: (input: string) => boolean,
): NodeProblem[] {
  if (node.type === GROUP && !own(level.document.groups, groupKeyOf(node)))
    return [
      problemAt('graph.group', place, msg`there is no group "${groupKeyOf(node)}"; choose one, or remove the node`),
    ];
  if ((node.type === GROUP_INPUT || node.type === GROUP_OUTPUT) && level.group === undefined)
    return [problemAt('graph.group', place, msg`it stands in no group; remove it`)];
  if (node.type === GROUP_OUTPUT && groupOutputOf(level) !== node)
    return [problemAt('graph.group', place, msg`a group has one group output; remove this one`)];
  const type = own(registry, node.type);
  if (!type) return [problemAt('graph.unknown-node', place, msg`there is no node type "${node.type}"`)];
  return [
    ...checkParams(place, node.params, type),
    ...(node.muted ? [] : checkConnections(place, node.params, type, isConnected)),
  ];
}

const groupOutputOf = ({ graph }: GraphLevel) => Object.values(graph.nodes).find(({ type }) => type === GROUP_OUTPUT);

/**
 * Why an edge is not allowed in a level of the document; undefined if it is. The edge need not exist yet; it replaces
 * the one that feeds its input now.
 */
export function edgeError(
  document: GraphDocument,
  edge: GraphEdge,
  registry: Registry,
  group?: string,
): Message | undefined {
  const level = levelOf(document, group);
  if (!level) return msg`there is no group "${group ?? ''}"`;
  const sockets = socketError(level, edge, registry);
  if (sockets) return sockets;
  const key = edgeKey(edge.to);
  const old = new Set(inferTypes(level, registry).conflicts.map(({ edge: { to } }) => edgeKey(to)));
  const conflict = inferTypes(level, registry, edge).conflicts.find(({ edge: { to } }) => {
    const at = edgeKey(to);
    return at === key || !old.has(at);
  });
  if (conflict) return conflict.message;
  return isReachable(level.graph, edge.to.node, edge.from.node) ? msg`this would close a cycle` : undefined;
}

function socketError(level: GraphLevel, { from, to }: GraphEdge, registry: Registry): Message | undefined {
  const [source, target] = [own(level.graph.nodes, from.node), own(level.graph.nodes, to.node)];
  const outputs = source && socketsOf(level, source, registry)?.outputs;
  const sockets = target && socketsOf(level, target, registry);
  if (!outputs || !own(outputs, from.output)) return msg`${from.node} has no output "${from.output}"`;
  return sockets && inputSocket(sockets, to.input) ? undefined : msg`${to.node} has no input "${to.input}"`;
}

/** Whether data flows from one node to another, over any number of edges; a node reaches itself. */
export const isReachable = (graph: Pick<GraphDocument, 'edges'>, from: string, to: string): boolean =>
  reachableFrom(graph, [from]).has(to);

/** All nodes that data flows to from the given ones, including these. */
export function reachableFrom({ edges }: Pick<GraphDocument, 'edges'>, starts: Iterable<string>): ReadonlySet<string> {
  const after = new Map<string, string[]>();
  for (const { from, to } of Object.values(edges)) {
    const list = after.get(from.node);
    if (list) list.push(to.node);
    else after.set(from.node, [to.node]);
  }
  const reached = new Set(starts);
  // A Set's iteration includes elements added during it.
  for (const node of reached) for (const next of after.get(node) ?? []) reached.add(next);
  return reached;
}

function checkParams(id: string, params: GraphNode['params'], type: NodeType): NodeProblem[] {
  return Object.entries(params).flatMap(([name, value]) => {
    const spec = own(type.params, name);
    const refusal = spec ? valueError(spec, value) : msg`there is no such parameter`;
    return refusal ? [problemAt('graph.param', `${id}.${name}`, refusal)] : [];
  });
}

function checkConnections(
  place: string,
  params: GraphNode['params'],
  type: NodeType,
  isConnected: (input: string) => boolean,
): NodeProblem[] {
  // Driven parameters are not known yet, so neither are the active inputs.
  const isDriven = Object.keys(type.params).some(isConnected);
  const needed = isDriven && type.needs ? [] : (type.needs?.(resolveParams(type, params)) ?? Object.keys(type.inputs));
  return needed.flatMap((name) => {
    const socket = type.inputs[name];
    if (!socket || socket.optional || isConnected(name)) return [];
    return [problemAt('graph.input', place, msg`connect something to "${name}" (${socket.type})`)];
  });
}

function levelCycles({ graph }: GraphLevel): ReadonlySet<string> {
  const into = incomingEdges(graph);
  return nodesInCycles(
    new Map(Object.keys(graph.nodes).map((id) => [id, (into.get(id) ?? []).map(({ from }) => from.node)])),
  );
}

const problemAt = (code: string, place: LocalizedText, message: Message): NodeProblem => ({
  severity: 'error',
  code,
  place,
  message,
});
