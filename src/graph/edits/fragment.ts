import * as z from 'zod/mini';
import {
  DocumentError,
  documentSchema,
  emptyDocument,
  type Graph,
  type GraphDocument,
  type GraphNode,
  graphIn,
  type NodeGroup,
  own,
} from '../document/document.ts';
import { findFault } from '../document/integrity.ts';
import { CURRENT_VERSION, migrate } from '../document/migrations.ts';
import { parseJson, parseWithSchema } from '../document/parse.ts';
import { sortKeys } from '../document/serialize.ts';
import { GROUP, groupKeyOf } from '../document/structuralTypes.ts';
import type { CanvasPoint, Command } from './commands.ts';
import { FreshKeys } from './freshKeys.ts';
import { layoutCenter, rekeyGraph, subgraphOf } from './subgraph.ts';

/** Nodes out of a document, with the groups that they use: what copying puts on the clipboard. */
const fragmentSchema = z.strictObject({
  ...z.omit(documentSchema, { files: true, title: true, lookFor: true }).shape,
  format: z.literal('slowlight-nodes'),
});
export type Fragment = z.infer<typeof fragmentSchema>;

/** What is chosen in a level of a document. */
export interface GraphSelection {
  readonly nodes: readonly string[];
  readonly notes?: readonly string[];
  /** Key of the group that the level is; absent of the document's own. */
  readonly group?: string;
}

export function copyFragment(document: GraphDocument, { nodes, notes, group }: GraphSelection): Fragment {
  const level = graphIn(document, group) ?? document;
  const part = subgraphOf(level, new Set(nodes), new Set(notes));
  return { format: 'slowlight-nodes', version: CURRENT_VERSION, ...part, groups: usedGroups(document, part) };
}

export const serializeFragment = (fragment: Fragment): string => JSON.stringify(sortKeys(fragment));

/** Reads what was copied, also by an earlier version. Throws a DocumentError with the place of the first fault. */
export function parseFragment(text: string): Fragment {
  const data = parseJson(text);
  const isFragment = typeof data === 'object' && data !== null && 'format' in data && data.format === 'slowlight-nodes';
  if (!isFragment) throw new DocumentError('format: these are no nodes of Slowlight');
  const migrated = migrate(data);
  // A whole document has files; a fragment of an earlier version has none to bring along.
  if (typeof migrated === 'object' && migrated !== null && 'files' in migrated) delete migrated.files;
  const fragment = parseWithSchema(fragmentSchema, migrated, 'no nodes of Slowlight');
  const fault = findFault({ ...emptyDocument(), ...fragment, format: 'slowlight' });
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
export function pasteFragment(document: GraphDocument, fragment: Fragment, group?: string, at?: CanvasPoint): Paste {
  const level = graphIn(document, group) ?? document;
  const groups = mergeGroups(document, fragment.groups);
  const keys = freshKeyMapping(level, fragment);
  const middle = layoutCenter(Object.values(fragment.layout));
  const shift: CanvasPoint = at ? [at[0] - middle[0], at[1] - middle[1]] : [40, 40];
  const added = rekeyGraph(withGroupKeys(fragment, groups.names), keys, shift);
  const insert: Command = { kind: 'insert', graph: added };
  return {
    command: {
      kind: 'batch',
      commands: [...groups.commands, group === undefined ? insert : insideGroup(group, insert)],
    },
    nodes: Object.keys(added.nodes),
    notes: Object.keys(added.notes),
  };
}

export const duplicateSelection = (document: GraphDocument, selection: GraphSelection): Paste =>
  pasteFragment(document, copyFragment(document, selection), selection.group);

export const insideGroup = (group: string | undefined, command: Command): Command =>
  group === undefined ? command : { kind: 'inside', group, command };

function freshKeyMapping(level: Graph, fragment: Fragment) {
  const names = (taken: object, wanted: object): ((key: string) => string) => {
    const fresh = new FreshKeys(taken);
    const found = new Map(Object.keys(wanted).map((key) => [key, fresh.next(key)]));
    return (key) => found.get(key) ?? key;
  };
  return {
    node: names(level.nodes, fragment.nodes),
    note: names(level.notes, fragment.notes),
    frame: names(level.frames, fragment.frames),
  };
}

/** The groups that the nodes of a graph use, and those that these use. */
function usedGroups(document: GraphDocument, graph: Graph): Record<string, NodeGroup> {
  const found = new Map<string, NodeGroup>();
  const open: Graph[] = [graph];
  for (let level = open.pop(); level; level = open.pop()) {
    for (const node of Object.values(level.nodes)) {
      const key = node.type === GROUP ? groupKeyOf(node) : '';
      const group = found.has(key) ? undefined : own(document.groups, key);
      if (!group) continue;
      found.set(key, group);
      open.push(group);
    }
  }
  return Object.fromEntries(found);
}

/** Groups that are there already, the same in all they hold, are used; others come under names that are free. */
function mergeGroups(document: GraphDocument, groups: Readonly<Record<string, NodeGroup>>) {
  const fresh = new FreshKeys(document.groups, groups);
  const text = (group: NodeGroup | undefined): string => JSON.stringify(sortKeys(group));
  const isTaken = (key: string): boolean => {
    const held = own(document.groups, key);
    return held !== undefined && text(held) !== text(groups[key]);
  };
  const clash = Object.keys(groups).some(isTaken);
  // Where one has to be called otherwise, so do those that use it.
  const names = new Map(Object.keys(groups).map((key) => [key, clash ? fresh.next(key) : key]));
  const commands = Object.entries(groups).flatMap(([key, group]): Command[] => {
    const name = names.get(key)!;
    if (own(document.groups, name)) return [];
    return [{ kind: 'set-group', group: name, value: { ...group, ...withGroupKeys(group, names) } }];
  });
  return { names, commands };
}

/** A graph whose nodes use their groups under other names. */
function withGroupKeys<G extends Graph>(graph: G, names: ReadonlyMap<string, string>): G {
  const nodes = Object.entries(graph.nodes).map(([id, node]): [string, GraphNode] => {
    const name = node.type === GROUP ? names.get(groupKeyOf(node)) : undefined;
    return [id, name === undefined ? node : { ...node, params: { ...node.params, group: name } }];
  });
  return { ...graph, nodes: Object.fromEntries(nodes) };
}
