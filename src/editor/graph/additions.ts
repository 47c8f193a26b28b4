import { type Level, levelOf } from '../../graph/sockets.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupOf } from '../../graph/structure.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import type { Addition } from './edits.ts';
import { type Loose, socketFor, socketForGroup } from './fit.ts';

/** A kind of node as lists have it: the key of a type, or `group:` and that of a group. */
interface Offered extends Addition {
  readonly id: string;
  readonly title: string;
  readonly help?: string;
  readonly category: string;
}

/** All that can be added to a level; to a loose end only what it can be connected to. */
export function additionsFor(level: Level, loose?: Loose): Offered[] {
  const types = Object.values(nodeLibrary).flatMap((type): Offered[] => {
    const { id, title, help, category } = type;
    if (id === GROUP || !isFor(level, id)) return [];
    const socket = loose && socketFor(level, type, loose);
    return loose && socket === undefined ? [] : [{ id, type: id, title, help, category, ...(socket && { socket }) }];
  });
  const groups = Object.entries(level.document.groups).flatMap(([group, { title }]): Offered[] => {
    if (holds(level, group, level.group)) return [];
    const socket = loose && socketForGroup(level, group, loose);
    if (loose && socket === undefined) return [];
    const words = { title: title || 'node.group', category: 'group' };
    return [{ id: `group:${group}`, type: GROUP, group, ...words, ...(socket && { socket }) }];
  });
  return [...types, ...groups];
}

/** What carries a group's sockets is in groups only, and each of them is there once. */
function isFor({ graph, group }: Level, type: string): boolean {
  if (type !== GROUP_INPUT && type !== GROUP_OUTPUT) return true;
  return group !== undefined && !Object.values(graph.nodes).some((node) => node.type === type);
}

/** Whether a group is another, or has it in it: then it cannot be put into that. */
function holds(level: Level, group: string, other: string | undefined): boolean {
  if (other === undefined) return false;
  if (group === other) return true;
  const inner = levelOf(level.document, group)?.graph.nodes ?? {};
  return Object.values(inner).some((node) => node.type === GROUP && holds(level, groupOf(node), other));
}
