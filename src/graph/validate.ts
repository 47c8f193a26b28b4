import type { GraphDocument, GraphEdge } from './document.ts';
import { type NodeType, type Problem, type Registry, refuseValue } from './nodeType.ts';

/** Everything that is wrong with a document as it stands, each at its node. */
export function validateDocument(document: GraphDocument, registry: Registry): Problem[] {
  const problems: Problem[] = [];
  for (const [id, node] of Object.entries(document.nodes)) {
    const type = registry[node.type];
    if (!type) {
      problems.push(error('graph.unknown-node', id, `there is no node type "${node.type}"`));
      continue;
    }
    problems.push(...checkParams(id, node.params, type), ...checkInputs(id, type, document));
  }
  for (const edge of Object.values(document.edges)) {
    const refusal = refuseEdge(document, edge, registry);
    if (refusal) problems.push(error('graph.edge', edge.to.node, refusal));
  }
  return problems;
}

/** Why the edge cannot be in the document, or undefined where it can. It need not be there yet. */
export function refuseEdge(document: GraphDocument, edge: GraphEdge, registry: Registry): string | undefined {
  const from = socketAt(document, registry, edge.from.node, 'outputs', edge.from.output);
  const to = socketAt(document, registry, edge.to.node, 'inputs', edge.to.input);
  if (!from) return `${edge.from.node} has no output "${edge.from.output}"`;
  if (!to) return `${edge.to.node} has no input "${edge.to.input}"`;
  if (from.type !== to.type) return `${from.type} does not fit ${to.type}`;
  return reaches(document, edge.to.node, edge.from.node) ? 'this would close a circle' : undefined;
}

/** Whether data flows from one node to another, over any number of edges; a node reaches itself. */
export function reaches(document: GraphDocument, from: string, to: string): boolean {
  const seen = new Set<string>();
  const open = [from];
  for (let node = open.pop(); node !== undefined; node = open.pop()) {
    if (node === to) return true;
    if (seen.has(node)) continue;
    seen.add(node);
    for (const edge of Object.values(document.edges)) if (edge.from.node === node) open.push(edge.to.node);
  }
  return false;
}

function checkParams(id: string, params: GraphDocument['nodes'][string]['params'], type: NodeType): Problem[] {
  return Object.entries(params).flatMap(([name, value]) => {
    const spec = type.params[name];
    const refusal = spec ? refuseValue(spec, value) : 'there is no such parameter';
    return refusal ? [error('graph.param', `${id}.${name}`, refusal)] : [];
  });
}

function checkInputs(id: string, type: NodeType, document: GraphDocument): Problem[] {
  return Object.entries(type.inputs).flatMap(([name, socket]) =>
    socket.optional || document.edges[`${id}.${name}`]
      ? []
      : [error('graph.input', id, `connect something to "${name}" (${socket.type})`)],
  );
}

function socketAt(document: GraphDocument, registry: Registry, node: string, side: 'inputs' | 'outputs', name: string) {
  const type = registry[document.nodes[node]?.type ?? ''];
  return type?.[side][name];
}

const error = (code: string, place: string, message: string): Problem => ({ severity: 'error', code, place, message });
