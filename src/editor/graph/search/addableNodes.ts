import { type GraphLevel, levelOf } from '../../../graph/analysis/sockets.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupKeyOf } from '../../../graph/document/structuralTypes.ts';
import type { NodeCategory } from '../../../graph/nodeType.ts';
import { type LocalizedText, type Message, msg } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { type PendingConnection, socketFor, socketForGroup } from '../commands/connections.ts';
import type { AddableNode } from '../commands/edits.ts';

/** A list entry: node type id, or `group:` and the group's id. */
interface AddableItem extends AddableNode {
  readonly id: string;
  readonly title: LocalizedText;
  readonly help?: Message;
  readonly category: NodeCategory | 'group';
}

/** All kinds of node that can be added to a level; with a pending connection, only those that fit it. */
export function addableNodes(level: GraphLevel, pendingEnd?: PendingConnection): AddableItem[] {
  const types = Object.values(nodeLibrary).flatMap((type): AddableItem[] => {
    const { id, title, help, category } = type;
    if (id === GROUP || !isAllowedIn(level, id)) return [];
    const socket = pendingEnd && socketFor(level, type, pendingEnd);
    return pendingEnd && socket === undefined
      ? []
      : [{ id, type: id, title, help, category, ...(socket && { socket }) }];
  });
  const groups = Object.entries(level.document.groups).flatMap(([group, { title }]): AddableItem[] => {
    if (containsGroup(level, group, level.group)) return [];
    const socket = pendingEnd && socketForGroup(level, group, pendingEnd);
    if (pendingEnd && socket === undefined) return [];
    const words = { title: title || msg`Group`, category: 'group' } as const;
    return [{ id: `group:${group}`, type: GROUP, group, ...words, ...(socket && { socket }) }];
  });
  return [...types, ...groups];
}

/** Group input and output nodes exist in groups only, once each. */
function isAllowedIn({ graph, group }: GraphLevel, type: string): boolean {
  if (type !== GROUP_INPUT && type !== GROUP_OUTPUT) return true;
  return group !== undefined && !Object.values(graph.nodes).some((node) => node.type === type);
}

/** Whether a group is or contains another, and so cannot be inserted into it. */
function containsGroup(level: GraphLevel, group: string, other: string | undefined): boolean {
  if (other === undefined) return false;
  if (group === other) return true;
  const inner = levelOf(level.document, group)?.graph.nodes ?? {};
  return Object.values(inner).some((node) => node.type === GROUP && containsGroup(level, groupKeyOf(node), other));
}
