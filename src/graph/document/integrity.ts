import { type Message, msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { edgeKey, type Graph, type GraphDocument, MAX_GROUP_DEPTH, MAX_NODES, own } from './document.ts';
import { GROUP, groupKeyOf } from './structuralTypes.ts';

/** The first inconsistency in a document, with its place; undefined if there is none. */
export function findFault(document: GraphDocument): Message | undefined {
  const levels = [document, ...Object.values(document.groups)];
  const nodes = levels.reduce((sum, level) => sum + Object.keys(level.nodes).length, 0);
  if (nodes > MAX_NODES) return msg`nodes: ${nodes} are more than the ${MAX_NODES} that a project may hold`;
  const inLevel =
    findGraphFault(document, '') ??
    firstFault(Object.entries(document.groups), ([id, group]) => {
      const place = `groups.${id}.`;
      return (
        findGraphFault(group, place) ??
        findDuplicate(group.inputs, `${place}inputs`) ??
        findDuplicate(group.outputs, `${place}outputs`)
      );
    });
  return inLevel ?? findDuplicate(document.marks ?? [], 'marks') ?? findRecursion(document);
}

function findGraphFault(graph: Graph, place: string): Message | undefined {
  const stranger = (id: string, where: string) =>
    own(graph.nodes, id) ? undefined : msg`${place}${where}: there is no node "${id}"`;
  return (
    firstFault(Object.entries(graph.edges), ([key, { from, to }]) => {
      if (key !== edgeKey(to)) return msg`${place}edges.${key}: it feeds ${edgeKey(to)}, and must be called so`;
      return stranger(from.node, `edges.${key}.from`) ?? stranger(to.node, `edges.${key}.to`);
    }) ??
    firstFault(Object.keys(graph.layout), (id) => stranger(id, `layout.${id}`)) ??
    firstFault(Object.entries(graph.frames), ([key, { nodes }]) =>
      firstFault(nodes, (id) => stranger(id, `frames.${key}.nodes`)),
    )
  );
}

function findDuplicate(sockets: readonly { readonly name: string }[], place: string): Message | undefined {
  const names = sockets.map(({ name }) => name);
  const found = names.find((name, i) => names.indexOf(name) !== i);
  return found === undefined ? undefined : msg`${place}: there are two of the name "${found}"`;
}

/** A group that contains itself, directly or indirectly, or is nested too deeply. */
function findRecursion(document: GraphDocument): Message | undefined {
  const heights = new Map<string, number>();
  const height = (id: string, above: readonly string[]): number => {
    if (above.includes(id)) throw new RecursionFault(msg`groups.${id}: it holds itself: ${[...above, id].join(' → ')}`);
    const known = heights.get(id);
    if (known !== undefined) return known;
    if (above.length > MAX_GROUP_DEPTH) throw new RecursionFault(depthFault(id));
    const inside = usedGroupKeys(own(document.groups, id)).filter((inner) => own(document.groups, inner));
    const found = 1 + Math.max(0, ...inside.map((inner) => height(inner, [...above, id])));
    heights.set(id, found);
    return found;
  };
  try {
    const deep = Object.keys(document.groups).find((id) => height(id, []) > MAX_GROUP_DEPTH);
    return deep === undefined ? undefined : depthFault(deep);
  } catch (error) {
    if (error instanceof RecursionFault) return error.text;
    throw error;
  }
}

const depthFault = (id: string) => msg`groups.${id}: groups lie more than ${MAX_GROUP_DEPTH} deep in one another`;

class RecursionFault extends MessageError {}

/** Distinct groups that a level's nodes use. */
function usedGroupKeys(graph: Graph | undefined): string[] {
  const used = Object.values(graph?.nodes ?? {}).flatMap((node) => (node.type === GROUP ? [groupKeyOf(node)] : []));
  return [...new Set(used)];
}

function firstFault<T>(items: readonly T[], find: (item: T) => Message | undefined): Message | undefined {
  for (const item of items) {
    const found = find(item);
    if (found !== undefined) return found;
  }
  return undefined;
}
