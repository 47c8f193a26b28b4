import { type GraphDocument, type GraphNode, graphIn, own } from '../../graph/document/document.ts';
import { locateNode } from '../../graph/edits/locateNode.ts';
import type { LocalizedText } from '../../messages/message.ts';
import { nodeLibrary } from '../../nodes/library.ts';

/** The user's title of a node given by its evaluation id. */
export const userTitle = (document: GraphDocument, id: string): string | undefined => nodeAt(document, id)?.title;

/** Title of a node in the graph: the user's, or its type's; undefined if the node does not exist. */
export function displayTitle(document: GraphDocument, id: string): LocalizedText | undefined {
  const node = nodeAt(document, id);
  return node && (node.title || own(nodeLibrary, node.type)?.title);
}

function nodeAt(document: GraphDocument, id: string): GraphNode | undefined {
  const place = locateNode(document, id);
  return place && own(graphIn(document, place.group)?.nodes ?? {}, place.node);
}
