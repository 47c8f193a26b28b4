import { msg } from '../../messages/message.ts';
import { edgeKey, type Graph, type GraphDocument, type GraphEdge, graphIn, own } from '../document/document.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupKeyOf } from '../document/structuralTypes.ts';
import { type Command, CommandError } from './commands.ts';
import { insideGroup } from './fragment.ts';
import { FreshKeys } from './freshKeys.ts';
import { layoutCenter, rekeyGraph, subgraphOf } from './subgraph.ts';

export interface Ungrouping {
  readonly command: Command;
  /** Ids of the nodes that the group contained. */
  readonly nodes: readonly string[];
}

/** Replaces a group node by the group's content; removes the group with its last instance. */
export function ungroupCommand(document: GraphDocument, node: string, parentGroup?: string): Ungrouping {
  const level = graphIn(document, parentGroup);
  const held = level && own(level.nodes, node);
  const key = held?.type === GROUP ? groupKeyOf(held) : '';
  const group = own(document.groups, key);
  if (!level || !group) throw new CommandError(msg`${node} is no group`);
  const content = Object.keys(group.nodes).filter((id) => !isBoundaryNode(group, id));
  const names = keyMappingFor(level, node, content, group);
  const [x, y] = level.layout[node] ?? [0, 0];
  const [mx, my] = layoutCenter(Object.values(group.layout));
  const out = rekeyGraph(subgraphOf(group, new Set(content), new Set(Object.keys(group.notes))), names, [
    x - mx,
    y - my,
  ]);
  const here: Command[] = [
    { kind: 'remove-nodes', nodes: [node] },
    { kind: 'insert', graph: out },
    ...reconnectedEdges(level, node, group, names.node).map((edge): Command => ({ kind: 'connect', edge })),
  ];
  const commands = [insideGroup(parentGroup, { kind: 'batch', commands: here })];
  if (countGroupUses(document, key) === 1) commands.push({ kind: 'set-group', group: key });
  return { command: { kind: 'batch', commands }, nodes: Object.keys(out.nodes) };
}

const isBoundaryNode = ({ nodes }: Graph, id: string): boolean =>
  nodes[id]?.type === GROUP_INPUT || nodes[id]?.type === GROUP_OUTPUT;

/** Number of instances of a group in the whole document. */
export const countGroupUses = (document: GraphDocument, group: string): number =>
  [document, ...Object.values(document.groups)]
    .flatMap(({ nodes }) => Object.values(nodes))
    .filter((held) => held.type === GROUP && groupKeyOf(held) === group).length;

function keyMappingFor(level: Graph, node: string, content: readonly string[], group: Graph) {
  const { [node]: _gone, ...left } = level.nodes;
  const keep = (taken: object, keys: readonly string[]) => {
    const fresh = new FreshKeys(taken);
    const found = new Map(keys.map((key) => [key, fresh.next(key)]));
    return (key: string): string => found.get(key) ?? key;
  };
  return {
    node: keep(left, content),
    note: keep(level.notes, Object.keys(group.notes)),
    frame: keep(level.frames, Object.keys(group.frames)),
  };
}

/** Edges between the group's former content and its surroundings. */
function reconnectedEdges(level: Graph, node: string, group: Graph, name: (key: string) => string): GraphEdge[] {
  const exit = Object.entries(group.nodes).find(([, { type }]) => type === GROUP_OUTPUT)?.[0];
  /** The source of an edge in the group, as seen from outside. */
  const source = ({ node: id, output }: GraphEdge['from']): GraphEdge['from'] | undefined =>
    group.nodes[id]?.type === GROUP_INPUT
      ? own(level.edges, edgeKey({ node, input: output }))?.from
      : { node: name(id), output };
  const joined = (from: GraphEdge['from'] | undefined, to: GraphEdge['to']): GraphEdge[] =>
    from ? [{ from, to }] : [];
  const inward = Object.values(group.edges).flatMap(({ from, to }) =>
    group.nodes[from.node]?.type === GROUP_INPUT && !isBoundaryNode(group, to.node)
      ? joined(source(from), { node: name(to.node), input: to.input })
      : [],
  );
  const outward = Object.values(level.edges).flatMap(({ from, to }) => {
    const inner =
      from.node === node && exit ? own(group.edges, edgeKey({ node: exit, input: from.output })) : undefined;
    return inner ? joined(source(inner.from), to) : [];
  });
  return [...inward, ...outward];
}
