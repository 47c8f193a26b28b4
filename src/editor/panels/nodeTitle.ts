import { type GraphDocument, type GraphNode, graphIn, own } from '../../graph/document/document.ts';
import { locateNode } from '../../graph/edits/locateNode.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { nodeLibrary } from '../../nodes/library.ts';

/** The user's title of a node given by its evaluation id. */
export const userTitle = (document: GraphDocument, id: string): string | undefined => nodeAt(document, id)?.title;

/** Title of a node in the graph: the user's, or its type's; undefined if the node does not exist. */
export function displayTitle(document: GraphDocument, id: string): LocalizedText | undefined {
  const node = nodeAt(document, id);
  return node && (node.title || own(nodeLibrary, node.type)?.title);
}

/** Of a place in the graph, `node` or `node.param`: titles of both; undefined for other places, such as a path in a scene. */
export function placeTitle(document: GraphDocument, place: string): LocalizedText | undefined {
  const node = displayTitle(document, place);
  if (node) return node;
  const dot = place.lastIndexOf('.');
  const owner = dot > 0 ? nodeAt(document, place.slice(0, dot)) : undefined;
  const type = owner && own(nodeLibrary, owner.type);
  const param = type && own(type.params, place.slice(dot + 1));
  return param && msg`${owner.title || type.title}: ${param.title}`;
}

function nodeAt(document: GraphDocument, id: string): GraphNode | undefined {
  const place = locateNode(document, id);
  return place && own(graphIn(document, place.group)?.nodes ?? {}, place.node);
}
