import { type GraphDocument, graphIn, own } from '../../graph/document.ts';
import { placeOf } from '../../graph/edits/place.ts';

/** What a person calls a node, which is named as evaluations name it. */
export function nodeTitle(document: GraphDocument, id: string): string | undefined {
  const place = placeOf(document, id);
  return place && own(graphIn(document, place.group)?.nodes ?? {}, place.node)?.title;
}
