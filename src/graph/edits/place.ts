import { type GraphDocument, graphIn, own } from '../document.ts';
import { GROUP, groupOf } from '../structure.ts';

/** Where a node stands in a document. */
export interface NodePlace {
  /** Key of the group whose definition holds it; absent of the document's own level. */
  readonly group?: string;
  readonly node: string;
}

/** Where a node stands that an evaluation names: of `outer/inner`, in the definition of the group that `outer` is. */
export function placeOf(document: GraphDocument, id: string): NodePlace | undefined {
  const path = id.split('/');
  const node = path.pop()!;
  let group: string | undefined;
  for (const step of path) {
    const level = graphIn(document, group);
    const held = level && own(level.nodes, step);
    if (held?.type !== GROUP) return undefined;
    group = groupOf(held);
  }
  const level = graphIn(document, group);
  if (!level || !own(level.nodes, node)) return undefined;
  return group === undefined ? { node } : { group, node };
}
