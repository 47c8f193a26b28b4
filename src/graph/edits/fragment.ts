import * as z from 'zod/mini';
import { msg } from '../../messages/message.ts';
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

/** Nodes of a document with the groups that they use: the clipboard format. */
const fragmentSchema = z.strictObject({
  ...z.omit(documentSchema, { files: true, title: true, lookFor: true, marks: true }).shape,
  format: z.literal('slowlight-nodes'),
});
export type Fragment = z.infer<typeof fragmentSchema>;

/** A selection in a level of a document. */
export interface GraphSelection {
  readonly nodes: readonly string[];
  readonly notes?: readonly string[];
  /** Id of the level's group; absent for the document's own level. */
  readonly group?: string;
}

export function copyFragment(document: GraphDocument, { nodes, notes, group }: GraphSelection): Fragment {
  const level = graphIn(document, group) ?? document;
  const part = subgraphOf(level, new Set(nodes), new Set(notes));
  return { format: 'slowlight-nodes', version: CURRENT_VERSION, ...part, groups: usedGroups(document, part) };
}

export const serializeFragment = (fragment: Fragment): string => JSON.stringify(sortKeys(fragment));

/** Parses copied text, also of earlier versions. Throws a DocumentError with the place of the first error. */
export function parseFragment(text: string): Fragment {
  const data = parseJson(text);
  const isFragment = typeof data === 'object' && data !== null && 'format' in data && data.format === 'slowlight-nodes';
  if (!isFragment) throw new DocumentError(msg`format: these are no nodes of Slowlight`);
  const migrated = migrate(data);
  // Migrated documents have files; fragments of earlier versions do not.
  if (typeof migrated === 'object' && migrated !== null && 'files' in migrated) delete migrated.files;
  const fragment = parseWithSchema(fragmentSchema, migrated);
  const fault = findFault({ ...emptyDocument(), ...fragment, format: 'slowlight' });
  if (fault) throw new DocumentError(fault);
  return fragment;
}

export interface Paste {
  readonly command: Command;
  /** New ids of the nodes, to be selected. */
  readonly nodes: readonly string[];
  readonly notes: readonly string[];
}

/** Inserts a fragment into a level: centered at `at`, or slightly offset from its original position. */
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

/** The groups that a graph's nodes use, directly and indirectly. */
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

/** Reuses existing groups with identical content; others are added under free ids. */
function mergeGroups(document: GraphDocument, groups: Readonly<Record<string, NodeGroup>>) {
  const fresh = new FreshKeys(document.groups, groups);
  const text = (group: NodeGroup | undefined): string => JSON.stringify(sortKeys(group));
  const isTaken = (key: string): boolean => {
    const held = own(document.groups, key);
    return held !== undefined && text(held) !== text(groups[key]);
  };
  const clash = Object.keys(groups).some(isTaken);
  // If one must be renamed, so must those that use it.
  const names = new Map(Object.keys(groups).map((key) => [key, clash ? fresh.next(key) : key]));
  const commands = Object.entries(groups).flatMap(([key, group]): Command[] => {
    const name = names.get(key)!;
    if (own(document.groups, name)) return [];
    return [{ kind: 'set-group', group: name, value: { ...group, ...withGroupKeys(group, names) } }];
  });
  return { names, commands };
}

/** A graph with its group references renamed. */
function withGroupKeys<G extends Graph>(graph: G, names: ReadonlyMap<string, string>): G {
  const nodes = Object.entries(graph.nodes).map(([id, node]): [string, GraphNode] => {
    const name = node.type === GROUP ? names.get(groupKeyOf(node)) : undefined;
    return [id, name === undefined ? node : { ...node, params: { ...node.params, group: name } }];
  });
  return { ...graph, nodes: Object.fromEntries(nodes) };
}
