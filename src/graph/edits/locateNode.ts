import { type GraphDocument, graphIn, own } from '../document/document.ts';
import { GROUP, groupKeyOf } from '../document/structuralTypes.ts';

/** Where a node is in a document. */
export interface NodeLocation {
  /** Id of the group whose definition contains it; absent for the document's own level. */
  readonly group?: string;
  readonly node: string;
}

/** Location of a node by its evaluation id: for `outer/inner`, in the definition of the group that `outer` uses. */
export function locateNode(document: GraphDocument, id: string): NodeLocation | undefined {
  const path = id.split('/');
  const node = path.pop()!;
  let group: string | undefined;
  for (const step of path) {
    const level = graphIn(document, group);
    const held = level && own(level.nodes, step);
    if (held?.type !== GROUP) return undefined;
    group = groupKeyOf(held);
  }
  const level = graphIn(document, group);
  if (!level || !own(level.nodes, node)) return undefined;
  return group === undefined ? { node } : { group, node };
}
