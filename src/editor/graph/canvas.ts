import { createStore, useStore } from 'zustand';
import type { Point } from '../../graph/commands.ts';
import { type GraphDocument, own } from '../../graph/document.ts';
import { type Level, levelOf } from '../../graph/sockets.ts';
import { GROUP, groupOf } from '../../graph/structure.ts';
import type { Loose } from './fit.ts';

/** What is chosen on the canvas; edges by the inputs that they feed, as the document has them. */
export interface Chosen {
  readonly nodes: readonly string[];
  readonly notes: readonly string[];
  readonly frames: readonly string[];
  readonly edges: readonly string[];
}
export const NOTHING: Chosen = { nodes: [], notes: [], frames: [], edges: [] };

/** What a node is being looked for to do. */
export interface Adding {
  /** Where on the canvas it is to stand. */
  readonly at: Point;
  /** Where the list opens, from the corner of the panel [px]. */
  readonly from: Point;
  /** The end of an edge that it is to be connected to. */
  readonly loose?: Loose;
  /** Only sockets of this node are offered, for the edge was dropped on it. */
  readonly onto?: string;
}

/** What the panel does with what it shows; there while it is shown. */
export interface Sight {
  /** The middle of what is seen, as a place on the canvas. */
  middle(): Point;
  /** From a place on the canvas to one in the panel [px]. */
  inPanel(at: Point): Point;
  /** Brings nodes into sight, or all that there is; `swing`: how long that takes [ms]. */
  fit(nodes?: readonly string[], swing?: number): void;
  zoom(factor: number): void;
  sizeOf(node: string): Point;
  /** With its picture, also where that has no room now. */
  roomFor(node: string): Point;
  placeOf(node: string): Point;
  /** Brings a node into sight, where it is not. */
  show(node: string): void;
  /** Whether any of a node is in sight. */
  sees(node: string): boolean;
  /** Gives the focus to a node, or to the canvas. */
  focus(node?: string): void;
}

/** How the graph is being looked at. What it holds is the document's alone. */
export interface CanvasState {
  /** The nodes of groups that were entered, from the outermost. */
  readonly path: readonly string[];
  readonly chosen: Chosen;
  /** An edge that is being drawn. */
  readonly loose?: Loose;
  /** What it fits, by node: `inputs geometry.2`. */
  readonly fits?: ReadonlyMap<string, ReadonlySet<string>>;
  readonly adding?: Adding;
  /** A note, frame or node whose words are being written: `note:n1`. */
  readonly writing?: string;
  readonly sight?: Sight;
  /** Nodes show small pictures of what they made. */
  readonly pictures: boolean;
}

export const canvas = createStore<CanvasState>(() => ({
  path: [],
  chosen: NOTHING,
  pictures: true,
}));
export const useCanvas = <T>(select: (state: CanvasState) => T): T => useStore(canvas, select);

/** The entered groups, as far as the document still has them: an undo may take one away. */
export function pathIn(document: GraphDocument, path: readonly string[]): readonly string[] {
  const found: string[] = [];
  let level = levelOf(document);
  for (const node of path) {
    const held = level && own(level.graph.nodes, node);
    level = held?.type === GROUP ? levelOf(document, groupOf(held)) : undefined;
    if (!level) break;
    found.push(node);
  }
  return found;
}

/** The level that a path leads to. */
export function levelAt(document: GraphDocument, path: readonly string[]): Level {
  let level: Level = { document, graph: document };
  for (const node of pathIn(document, path)) {
    const held = level.graph.nodes[node]!;
    level = levelOf(document, groupOf(held)) ?? level;
  }
  return level;
}

/** As an evaluation names a node of a level. */
export const flatName = (path: readonly string[], node: string): string => [...path, node].join('/');

/** What of a choice is still there. */
export function chosenIn({ graph }: Level, { nodes, notes, frames, edges }: Chosen): Chosen {
  const held = (table: object) => (key: string) => Object.hasOwn(table, key);
  return {
    nodes: nodes.filter(held(graph.nodes)),
    notes: notes.filter(held(graph.notes)),
    frames: frames.filter(held(graph.frames)),
    edges: edges.filter(held(graph.edges)),
  };
}

export const choose = (chosen: Partial<Chosen>): void => canvas.setState({ chosen: { ...NOTHING, ...chosen } });
