import type { Edge, Node, NodeHandle } from '@xyflow/react';
import { Position } from '@xyflow/react';
import type { Point } from '../../graph/commands.ts';
import { edgeKey, type Frame, type Note } from '../../graph/document.ts';
import type { LevelTypes } from '../../graph/infer.ts';
import type { Level } from '../../graph/sockets.ts';
import { REROUTE } from '../../graph/structure.ts';
import type { Chosen } from './canvas.ts';
import type { Face } from './face.ts';
import { type Box, frameBox, SOCKET, sizeOf, socketPlaces } from './shape.ts';

/**
 * A level of the document as React Flow has it. It is made anew from the document whenever that changes; what came out the same stays
 * the same object, and is not drawn again.
 */
export type CardNode = Node<{ readonly face: Face; readonly reach: Point }, 'card' | 'dot'>;
export type NoteNode = Node<{ readonly id: string; readonly note: Note }, 'note'>;
export type FrameNode = Node<{ readonly id: string; readonly frame: Frame }, 'frame'>;
export type FlowNode = CardNode | NoteNode | FrameNode;
export type WireEdge = Edge<{ readonly type: string; readonly conflict: boolean }, 'wire'>;

/** Notes and frames are nodes too, to React Flow; their keys are told from nodes' by what stands before them. */
const NOTE = 'note:';
const FRAME = 'frame:';

export type Thing = { readonly kind: 'node' | 'note' | 'frame'; readonly key: string };

export function thingOf(id: string): Thing {
  if (id.startsWith(NOTE)) return { kind: 'note', key: id.slice(NOTE.length) };
  if (id.startsWith(FRAME)) return { kind: 'frame', key: id.slice(FRAME.length) };
  return { kind: 'node', key: id };
}

/** What was made before, under what it was made of. */
export class Kept<Item> {
  #before = new Map<string, { readonly of: string; readonly item: Item }>();
  #now = new Map<string, { readonly of: string; readonly item: Item }>();

  /** `of`: all that the item depends on. */
  take(id: string, of: string, make: () => Item): Item {
    const before = this.#before.get(id);
    const kept = before?.of === of ? before : { of, item: make() };
    this.#now.set(id, kept);
    return kept.item;
  }

  /** Forgets what was not taken since the last time. */
  turn(): void {
    this.#before = this.#now;
    this.#now = new Map();
  }
}

export interface Scenery {
  readonly level: Level;
  readonly faces: ReadonlyMap<string, Face>;
  readonly places: Readonly<Record<string, Point>>;
  /** Where notes are while they are dragged. */
  readonly notes: Readonly<Record<string, Point>>;
  readonly chosen: Chosen;
  /** How far titles may reach beyond their nodes (far.ts). */
  readonly reaches: ReadonlyMap<string, Point>;
  /** What a node is to screen readers. */
  nameOf(face: Face): string;
}

/** Frames lie under notes, notes under nodes. */
export function flowNodes(scenery: Scenery, kept: Kept<FlowNode>): FlowNode[] {
  const { level, faces, places, chosen, reaches } = scenery;
  const boxOf = (id: string): Box | undefined => {
    const [face, at] = [faces.get(id), places[id]];
    return face && at && { at, size: sizeOf(face) };
  };
  const frames = Object.entries(level.graph.frames).flatMap(([key, frame]): FlowNode[] => {
    const box = frameBox(frame, boxOf);
    if (!box) return [];
    const selected = chosen.frames.includes(key);
    return [kept.take(FRAME + key, JSON.stringify([frame, box, selected]), () => frameNode(key, frame, box, selected))];
  });
  const notes = Object.entries(level.graph.notes).map(([key, note]): FlowNode => {
    const at = scenery.notes[key] ?? note.at;
    const selected = chosen.notes.includes(key);
    return kept.take(NOTE + key, JSON.stringify([note, at, selected]), () => noteNode(key, note, at, selected));
  });
  const selected = new Set(chosen.nodes);
  const cards = [...faces.values()].map((face): FlowNode => {
    const at = places[face.id] ?? [0, 0];
    const isSelected = selected.has(face.id);
    const name = scenery.nameOf(face);
    const reach = reaches.get(face.id) ?? [0, 0];
    return kept.take(face.id, JSON.stringify([face, at, isSelected, name, reach]), () => ({
      ...cardNode(face, at, isSelected, reach),
      ariaLabel: name,
    }));
  });
  kept.turn();
  return [...frames, ...notes, ...cards];
}

const sized = ([width, height]: Point) => ({ width, height, measured: { width, height } });
const position = ([x, y]: Point) => ({ x, y });

const frameNode = (id: string, frame: Frame, { at, size }: Box, selected: boolean): FrameNode => ({
  id: FRAME + id,
  type: 'frame',
  position: position(at),
  ...sized(size),
  handles: [],
  data: { id, frame },
  selected,
  connectable: false,
  zIndex: -2,
  // What lies in a frame is reached through it.
  style: { pointerEvents: 'none' },
  dragHandle: '.sl-frame-title',
  ariaLabel: frame.title,
});

const noteNode = (id: string, note: Note, at: Point, selected: boolean): NoteNode => ({
  id: NOTE + id,
  type: 'note',
  position: position(at),
  ...sized(note.size),
  handles: [],
  data: { id, note },
  selected,
  connectable: false,
  zIndex: -1,
  ariaLabel: note.text,
});

const cardNode = (face: Face, at: Point, selected: boolean, reach: Point): CardNode => ({
  id: face.id,
  type: face.type === REROUTE ? 'dot' : 'card',
  position: position(at),
  ...sized(sizeOf(face)),
  handles: socketPlaces(face).map(
    ({ side, socket, at: [x, y] }): NodeHandle => ({
      id: socket.name,
      type: side === 'inputs' ? 'target' : 'source',
      position: side === 'inputs' ? Position.Left : Position.Right,
      // Edges end at the middle of a mark.
      x: side === 'inputs' ? x : x - SOCKET,
      y: y - SOCKET / 2,
      width: SOCKET,
      height: SOCKET,
    }),
  ),
  data: { face, reach },
  selected,
});

export function flowEdges(level: Level, types: LevelTypes, chosen: Chosen, kept: Kept<WireEdge>): WireEdge[] {
  const conflicts = new Set(types.conflicts.map(({ edge }) => edgeKey(edge.to)));
  const edges = Object.entries(level.graph.edges).map(([id, { from, to }]) => {
    const type = types.typeOf(from.node, 'outputs', from.output) ?? 'any';
    const conflict = conflicts.has(id);
    const selected = chosen.edges.includes(id);
    const make = (): WireEdge => ({
      id,
      type: 'wire',
      source: from.node,
      sourceHandle: from.output,
      target: to.node,
      targetHandle: to.input,
      data: { type, conflict },
      selected,
    });
    return kept.take(id, JSON.stringify([from, type, conflict, selected]), make);
  });
  kept.turn();
  return edges;
}
