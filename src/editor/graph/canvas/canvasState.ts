import { createStore, useStore } from 'zustand';
import { type GraphLevel, levelOf } from '../../../graph/analysis/sockets.ts';
import { type GraphDocument, own } from '../../../graph/document/document.ts';
import { GROUP, groupKeyOf } from '../../../graph/document/structuralTypes.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import type { PendingConnection } from '../commands/connections.ts';

/** What is chosen on the canvas; edges by the inputs that they feed, as the document has them. */
export interface CanvasSelection {
  readonly nodes: readonly string[];
  readonly notes: readonly string[];
  readonly frames: readonly string[];
  readonly edges: readonly string[];
}
export const EMPTY_SELECTION: CanvasSelection = { nodes: [], notes: [], frames: [], edges: [] };

/** What a node is being looked for to do. */
export interface AddNodeRequest {
  /** Where on the canvas it is to stand. */
  readonly at: CanvasPoint;
  /** Where the list opens, from the corner of the panel [px]. */
  readonly from: CanvasPoint;
  /** The end of an edge that it is to be connected to. */
  readonly pending?: PendingConnection;
  /** Only sockets of this node are offered, for the edge was dropped on it. */
  readonly onto?: string;
}

/** What the panel does with what it shows; there while it is shown. */
export interface CanvasViewport {
  /** The middle of what is seen, as a place on the canvas. */
  center(): CanvasPoint;
  /** From a place on the canvas to one in the panel [px]. */
  toPanel(at: CanvasPoint): CanvasPoint;
  /** Brings nodes into sight, or all that there is; `swing`: how long that takes [ms]. */
  fit(nodes?: readonly string[], swing?: number): void;
  zoom(factor: number): void;
  sizeOf(node: string): CanvasPoint;
  /** With its picture, also where that has no room now. */
  sizeWithPicture(node: string): CanvasPoint;
  positionOf(node: string): CanvasPoint;
  /** Brings a node into sight, where it is not. */
  reveal(node: string): void;
  /** Whether any of a node is in sight. */
  isVisible(node: string): boolean;
  /** Gives the focus to a node, or to the canvas. */
  focus(node?: string): void;
}

/** How the graph is being looked at. What it holds is the document's alone. */
export interface CanvasState {
  /** The nodes of groups that were entered, from the outermost. */
  readonly path: readonly string[];
  readonly selection: CanvasSelection;
  /** An edge that is being drawn. */
  readonly pending?: PendingConnection;
  /** What it fits, by node: `inputs geometry.2`. */
  readonly compatibleSockets?: ReadonlyMap<string, ReadonlySet<string>>;
  readonly adding?: AddNodeRequest;
  /** A note, frame or node whose words are being written: `note:n1`. */
  readonly editing?: string;
  readonly viewport?: CanvasViewport;
  /** Nodes show small pictures of what they made. */
  readonly pictures: boolean;
}

export const canvas = createStore<CanvasState>(() => ({
  path: [],
  selection: EMPTY_SELECTION,
  pictures: true,
}));
export const useCanvas = <T>(select: (state: CanvasState) => T): T => useStore(canvas, select);

/** The entered groups, as far as the document still has them: an undo may take one away. */
export function existingPath(document: GraphDocument, path: readonly string[]): readonly string[] {
  const found: string[] = [];
  let level = levelOf(document);
  for (const node of path) {
    const held = level && own(level.graph.nodes, node);
    level = held?.type === GROUP ? levelOf(document, groupKeyOf(held)) : undefined;
    if (!level) break;
    found.push(node);
  }
  return found;
}

/** The level that a path leads to. */
export function levelAt(document: GraphDocument, path: readonly string[]): GraphLevel {
  let level: GraphLevel = { document, graph: document };
  for (const node of existingPath(document, path)) {
    const held = level.graph.nodes[node]!;
    level = levelOf(document, groupKeyOf(held)) ?? level;
  }
  return level;
}

/** As an evaluation names a node of a level. */
export const flatNodeId = (path: readonly string[], node: string): string => [...path, node].join('/');

/** What of a choice is still there. */
export function prunedSelection(
  { graph }: GraphLevel,
  { nodes, notes, frames, edges }: CanvasSelection,
): CanvasSelection {
  const held = (table: object) => (key: string) => Object.hasOwn(table, key);
  return {
    nodes: nodes.filter(held(graph.nodes)),
    notes: notes.filter(held(graph.notes)),
    frames: frames.filter(held(graph.frames)),
    edges: edges.filter(held(graph.edges)),
  };
}

export const selectItems = (chosen: Partial<CanvasSelection>): void =>
  canvas.setState({ selection: { ...EMPTY_SELECTION, ...chosen } });
