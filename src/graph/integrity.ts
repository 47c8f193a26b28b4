import { DEEPEST_GROUP, edgeKey, type Graph, type GraphDocument, MOST_NODES, own } from './document.ts';
import { GROUP, groupOf } from './structure.ts';

/** The first thing by which a document contradicts itself, with its place; undefined where it does not. */
export function faultIn(document: GraphDocument): string | undefined {
  const levels = [document, ...Object.values(document.groups)];
  const nodes = levels.reduce((sum, level) => sum + Object.keys(level.nodes).length, 0);
  if (nodes > MOST_NODES) return `nodes: ${nodes} are more than the ${MOST_NODES} that a project may hold`;
  const inLevel =
    faultInGraph(document, '') ??
    first(Object.entries(document.groups), ([id, group]) => {
      const place = `groups.${id}.`;
      return (
        faultInGraph(group, place) ?? twice(group.inputs, `${place}inputs`) ?? twice(group.outputs, `${place}outputs`)
      );
    });
  return inLevel ?? recursionIn(document);
}

function faultInGraph(graph: Graph, place: string): string | undefined {
  const stranger = (id: string, where: string) =>
    own(graph.nodes, id) ? undefined : `${place}${where}: there is no node "${id}"`;
  return (
    first(Object.entries(graph.edges), ([key, { from, to }]) => {
      if (key !== edgeKey(to)) return `${place}edges.${key}: it feeds ${edgeKey(to)}, and must be called so`;
      return stranger(from.node, `edges.${key}.from`) ?? stranger(to.node, `edges.${key}.to`);
    }) ??
    first(Object.keys(graph.layout), (id) => stranger(id, `layout.${id}`)) ??
    first(Object.entries(graph.frames), ([key, { nodes }]) => first(nodes, (id) => stranger(id, `frames.${key}.nodes`)))
  );
}

function twice(sockets: readonly { readonly name: string }[], place: string): string | undefined {
  const names = sockets.map(({ name }) => name);
  const found = names.find((name, i) => names.indexOf(name) !== i);
  return found === undefined ? undefined : `${place}: there are two of the name "${found}"`;
}

/** A group that holds itself, over any number of others, or lies too deep. */
function recursionIn(document: GraphDocument): string | undefined {
  const heights = new Map<string, number>();
  const height = (id: string, above: readonly string[]): number => {
    if (above.includes(id)) throw new Recursion(`groups.${id}: it holds itself: ${[...above, id].join(' → ')}`);
    const known = heights.get(id);
    if (known !== undefined) return known;
    if (above.length > DEEPEST_GROUP) throw new Recursion(tooDeep(id));
    const inside = groupsIn(own(document.groups, id)).filter((inner) => own(document.groups, inner));
    const found = 1 + Math.max(0, ...inside.map((inner) => height(inner, [...above, id])));
    heights.set(id, found);
    return found;
  };
  try {
    const deep = Object.keys(document.groups).find((id) => height(id, []) > DEEPEST_GROUP);
    return deep === undefined ? undefined : tooDeep(deep);
  } catch (error) {
    if (error instanceof Recursion) return error.message;
    throw error;
  }
}

const tooDeep = (id: string) => `groups.${id}: groups lie more than ${DEEPEST_GROUP} deep in one another`;

class Recursion extends Error {}

/** The groups that a level's nodes use, each once. */
function groupsIn(graph: Graph | undefined): string[] {
  const used = Object.values(graph?.nodes ?? {}).flatMap((node) => (node.type === GROUP ? [groupOf(node)] : []));
  return [...new Set(used)];
}

function first<T>(items: readonly T[], find: (item: T) => string | undefined): string | undefined {
  for (const item of items) {
    const found = find(item);
    if (found !== undefined) return found;
  }
  return undefined;
}
