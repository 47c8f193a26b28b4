import { type Graph, type GraphDocument, graphIn, own } from '../../graph/document.ts';
import { placeOf } from '../../graph/edits/place.ts';
import { nodeLibrary } from '../../nodes/library.ts';

/** By its inputs that are connected, what the nodes are called that feed a node; keys of the catalogue, or plain words. */
export function feedersOf({ nodes, edges }: Graph, node: string): Readonly<Record<string, string>> {
  const found = Object.values(edges).flatMap(({ from, to }): [string, string][] => {
    const feeder = to.node === node ? own(nodes, from.node) : undefined;
    return feeder ? [[to.input, feeder.title ?? nodeLibrary[feeder.type]?.title ?? feeder.type]] : [];
  });
  return Object.fromEntries(found);
}

/** As `feedersOf`, of a node as evaluations name it. */
export function feedersIn(document: GraphDocument, flat: string): Readonly<Record<string, string>> {
  const place = placeOf(document, flat);
  const level = place && graphIn(document, place.group);
  return level ? feedersOf(level, place.node) : {};
}
