import { type Graph, type GraphDocument, graphIn, own } from '../../graph/document/document.ts';
import { locateNode } from '../../graph/edits/locateNode.ts';
import { nodeLibrary } from '../../nodes/library.ts';

/** By its inputs that are connected, what the nodes are called that feed a node; keys of the catalogue, or plain words. */
export function drivenInputTitles({ nodes, edges }: Graph, node: string): Readonly<Record<string, string>> {
  const found = Object.values(edges).flatMap(({ from, to }): [string, string][] => {
    const feeder = to.node === node ? own(nodes, from.node) : undefined;
    return feeder ? [[to.input, feeder.title ?? nodeLibrary[feeder.type]?.title ?? feeder.type]] : [];
  });
  return Object.fromEntries(found);
}

/** As `drivenInputTitles`, of a node as evaluations name it. */
export function drivenInputTitlesOf(document: GraphDocument, flat: string): Readonly<Record<string, string>> {
  const place = locateNode(document, flat);
  const level = place && graphIn(document, place.group);
  return level ? drivenInputTitles(level, place.node) : {};
}
