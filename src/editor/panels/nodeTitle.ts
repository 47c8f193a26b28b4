import { type GraphDocument, type GraphNode, graphIn, own } from '../../graph/document/document.ts';
import { locateNode } from '../../graph/edits/locateNode.ts';
import { nodeLibrary } from '../../nodes/library.ts';

/** What a person calls a node, which is named as evaluations name it. */
export const userTitle = (document: GraphDocument, id: string): string | undefined => nodeAt(document, id)?.title;

/** What a node is called in the graph, by the person or after its kind; undefined where there is no such node. */
export function displayTitle(document: GraphDocument, id: string): string | undefined {
  const node = nodeAt(document, id);
  return node && (node.title || own(nodeLibrary, node.type)?.title);
}

function nodeAt(document: GraphDocument, id: string): GraphNode | undefined {
  const place = locateNode(document, id);
  return place && own(graphIn(document, place.group)?.nodes ?? {}, place.node);
}
