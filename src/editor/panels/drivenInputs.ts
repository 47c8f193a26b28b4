import { type Graph, type GraphDocument, graphIn, own } from '../../graph/document/document.ts';
import { locateNode } from '../../graph/edits/locateNode.ts';
import type { LocalizedText } from '../../messages/message.ts';
import { nodeLibrary } from '../../nodes/library.ts';

/** Titles of the nodes that feed a node, by connected input. */
export function drivenInputTitles({ nodes, edges }: Graph, node: string): Readonly<Record<string, LocalizedText>> {
  const found = Object.values(edges).flatMap(({ from, to }): [string, LocalizedText][] => {
    const feeder = to.node === node ? own(nodes, from.node) : undefined;
    return feeder ? [[to.input, feeder.title ?? nodeLibrary[feeder.type]?.title ?? feeder.type]] : [];
  });
  return Object.fromEntries(found);
}

/** As `drivenInputTitles`, for a node given by its evaluation id. */
export function drivenInputTitlesOf(document: GraphDocument, flat: string): Readonly<Record<string, LocalizedText>> {
  const place = locateNode(document, flat);
  const level = place && graphIn(document, place.group);
  return level ? drivenInputTitles(level, place.node) : {};
}
