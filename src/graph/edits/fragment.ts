import * as z from 'zod/mini';
import type { Command, Point } from '../commands.ts';
import {
  DocumentError,
  documentSchema,
  emptyDocument,
  type Graph,
  type GraphDocument,
  type GraphNode,
  type Group,
  graphIn,
  own,
} from '../document.ts';
import { faultIn } from '../integrity.ts';
import { CURRENT_VERSION, migrate } from '../migrations.ts';
import { checked, parseJson } from '../read.ts';
import { sorted } from '../serialize.ts';
import { GROUP, groupOf } from '../structure.ts';
import { FreshKeys } from './fresh.ts';
import { middleOf, partOf, renamed } from './renamed.ts';

/** Nodes out of a document, with the groups that they use: what copying puts on the clipboard. */
const fragmentSchema = z.strictObject({
  ...z.omit(documentSchema, { files: true, title: true, lookFor: true }).shape,
  format: z.literal('slowlight-nodes'),
});
export type Fragment = z.infer<typeof fragmentSchema>;

/** What is chosen in a level of a document. */
export interface Selection {
  readonly nodes: readonly string[];
  readonly notes?: readonly string[];
  /** Key of the group that the level is; absent of the document's own. */
  readonly group?: string;
}

export function copyOf(document: GraphDocument, { nodes, notes, group }: Selection): Fragment {
  const level = graphIn(document, group) ?? document;
  const part = partOf(level, new Set(nodes), new Set(notes));
  return { format: 'slowlight-nodes', version: CURRENT_VERSION, ...part, groups: groupsUsed(document, part) };
}

export const serializeFragment = (fragment: Fragment): string => JSON.stringify(sorted(fragment));

/** Reads what was copied, also by an earlier version. Throws a DocumentError with the place of the first fault. */
export function parseFragment(text: string): Fragment {
  const data = parseJson(text);
  const isFragment = typeof data === 'object' && data !== null && 'format' in data && data.format === 'slowlight-nodes';
  if (!isFragment) throw new DocumentError('format: these are no nodes of Slowlight');
  const migrated = migrate(data);
  // A whole document has files; a fragment of an earlier version has none to bring along.
  if (typeof migrated === 'object' && migrated !== null && 'files' in migrated) delete migrated.files;
  const fragment = checked(fragmentSchema, migrated, 'no nodes of Slowlight');
  const fault = faultIn({ ...emptyDocument(), ...fragment, format: 'slowlight' });
  if (fault) throw new DocumentError(fault);
  return fragment;
}

export interface Paste {
  readonly command: Command;
  /** What the nodes are called now: they become the selection. */
  readonly nodes: readonly string[];
  readonly notes: readonly string[];
}

/** Adds a fragment to a level: its middle at `at`, or without that a little beside where it was. */
export function pasteOf(document: GraphDocument, fragment: Fragment, group?: string, at?: Point): Paste {
  const level = graphIn(document, group) ?? document;
  const groups = groupsFor(document, fragment.groups);
  const keys = renaming(level, fragment);
  const middle = middleOf(Object.values(fragment.layout));
  const shift: Point = at ? [at[0] - middle[0], at[1] - middle[1]] : [40, 40];
  const added = renamed(withGroups(fragment, groups.names), keys, shift);
  const insert: Command = { kind: 'insert', graph: added };
  return {
    command: { kind: 'batch', commands: [...groups.commands, group === undefined ? insert : inside(group, insert)] },
    nodes: Object.keys(added.nodes),
    notes: Object.keys(added.notes),
  };
}

export const duplicateOf = (document: GraphDocument, selection: Selection): Paste =>
  pasteOf(document, copyOf(document, selection), selection.group);

export const inside = (group: string | undefined, command: Command): Command =>
  group === undefined ? command : { kind: 'inside', group, command };

function renaming(level: Graph, fragment: Fragment) {
  const names = (taken: object, wanted: object): ((key: string) => string) => {
    const fresh = new FreshKeys(taken);
    const found = new Map(Object.keys(wanted).map((key) => [key, fresh.take(key)]));
    return (key) => found.get(key) ?? key;
  };
  return {
    node: names(level.nodes, fragment.nodes),
    note: names(level.notes, fragment.notes),
    frame: names(level.frames, fragment.frames),
  };
}

/** The groups that the nodes of a graph use, and those that these use. */
function groupsUsed(document: GraphDocument, graph: Graph): Record<string, Group> {
  const found = new Map<string, Group>();
  const open: Graph[] = [graph];
  for (let level = open.pop(); level; level = open.pop()) {
    for (const node of Object.values(level.nodes)) {
      const key = node.type === GROUP ? groupOf(node) : '';
      const group = found.has(key) ? undefined : own(document.groups, key);
      if (!group) continue;
      found.set(key, group);
      open.push(group);
    }
  }
  return Object.fromEntries(found);
}

/** Groups that are there already, the same in all they hold, are used; others come under names that are free. */
function groupsFor(document: GraphDocument, groups: Readonly<Record<string, Group>>) {
  const fresh = new FreshKeys(document.groups, groups);
  const text = (group: Group | undefined): string => JSON.stringify(sorted(group));
  const isTaken = (key: string): boolean => {
    const held = own(document.groups, key);
    return held !== undefined && text(held) !== text(groups[key]);
  };
  const clash = Object.keys(groups).some(isTaken);
  // Where one has to be called otherwise, so do those that use it.
  const names = new Map(Object.keys(groups).map((key) => [key, clash ? fresh.take(key) : key]));
  const commands = Object.entries(groups).flatMap(([key, group]): Command[] => {
    const name = names.get(key)!;
    if (own(document.groups, name)) return [];
    return [{ kind: 'set-group', group: name, value: { ...group, ...withGroups(group, names) } }];
  });
  return { names, commands };
}

/** A graph whose nodes use their groups under other names. */
function withGroups<G extends Graph>(graph: G, names: ReadonlyMap<string, string>): G {
  const nodes = Object.entries(graph.nodes).map(([id, node]): [string, GraphNode] => {
    const name = node.type === GROUP ? names.get(groupOf(node)) : undefined;
    return [id, name === undefined ? node : { ...node, params: { ...node.params, group: name } }];
  });
  return { ...graph, nodes: Object.fromEntries(nodes) };
}
