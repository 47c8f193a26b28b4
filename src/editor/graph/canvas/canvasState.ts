import { createStore, useStore } from 'zustand';
import { type GraphLevel, levelOf } from '../../../graph/analysis/sockets.ts';
import { type GraphDocument, own } from '../../../graph/document/document.ts';
import { GROUP, groupKeyOf } from '../../../graph/document/structuralTypes.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import type { PendingConnection } from '../commands/connections.ts';

/** Selection on the canvas; edges are identified by the inputs they feed, as in the document. */
export interface CanvasSelection {
  readonly nodes: readonly string[];
  readonly notes: readonly string[];
  readonly frames: readonly string[];
  readonly edges: readonly string[];
}
export const EMPTY_SELECTION: CanvasSelection = { nodes: [], notes: [], frames: [], edges: [] };

/** A request to add a node. */
export interface AddNodeRequest {
  /** Where to place it on the canvas. */
  readonly at: CanvasPoint;
  /** Position of the list, relative to the panel's corner [px]. */
  readonly from: CanvasPoint;
  /** The pending connection to attach it to. */
  readonly pending?: PendingConnection;
  /** Restricts the list to sockets of this node, on which the edge was dropped. */
  readonly onto?: string;
}

/** Operations on the visible part of the canvas; set while the panel is mounted. */
export interface CanvasViewport {
  /** Center of the visible part, in canvas coordinates. */
  center(): CanvasPoint;
  /** Canvas coordinates → panel coordinates [px]. */
  toPanel(at: CanvasPoint): CanvasPoint;
  /** Fits nodes, or all, into the viewport; `swing`: duration of the transition [ms]. */
  fit(nodes?: readonly string[], swing?: number): void;
  zoom(factor: number): void;
  sizeOf(node: string): CanvasPoint;
  /** Size with its picture, also where the picture is currently hidden for lack of space. */
  sizeWithPicture(node: string): CanvasPoint;
  positionOf(node: string): CanvasPoint;
  /** Scrolls a node into view if needed. */
  reveal(node: string): void;
  /** Whether any part of a node is visible. */
  isVisible(node: string): boolean;
  /** Focuses a node, or the canvas. */
  focus(node?: string): void;
}

/** View state of the graph. Its content is in the document only. */
export interface CanvasState {
  /** Ids of the entered group nodes, outermost first. */
  readonly path: readonly string[];
  readonly selection: CanvasSelection;
  /** The edge being drawn. */
  readonly pending?: PendingConnection;
  /** Sockets that the pending connection fits, by node: `inputs geometry.2`. */
  readonly compatibleSockets?: ReadonlyMap<string, ReadonlySet<string>>;
  readonly adding?: AddNodeRequest;
  /** The note, frame or node whose text is being edited: `note:n1`. */
  readonly editing?: string;
  readonly viewport?: CanvasViewport;
  /** Whether nodes show pictures of their results. */
  readonly pictures: boolean;
}

export const canvas = createStore<CanvasState>(() => ({
  path: [],
  selection: EMPTY_SELECTION,
  pictures: true,
}));
export const useCanvas = <T>(select: (state: CanvasState) => T): T => useStore(canvas, select);

/** The entered groups that still exist: an undo may remove one. */
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

/** The level at a path. */
export function levelAt(document: GraphDocument, path: readonly string[]): GraphLevel {
  let level: GraphLevel = { document, graph: document };
  for (const node of existingPath(document, path)) {
    const held = level.graph.nodes[node]!;
    level = levelOf(document, groupKeyOf(held)) ?? level;
  }
  return level;
}

/** Id of a node of a level in evaluation results. */
export const flatNodeId = (path: readonly string[], node: string): string => [...path, node].join('/');

/** The part of a selection that still exists. */
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
