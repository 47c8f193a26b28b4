import type { Edge, Node, NodeHandle } from '@xyflow/react';
import { Position } from '@xyflow/react';
import type { LevelTypes } from '../../../graph/analysis/inferTypes.ts';
import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import { edgeKey, type GraphFrame, type GraphNote } from '../../../graph/document/document.ts';
import { REROUTE } from '../../../graph/document/structuralTypes.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { msg, type Translate } from '../../../messages/message.ts';
import { type CanvasRect, cardSize, frameRect, SOCKET_SIZE, socketPositions } from '../cards/cardGeometry.ts';
import type { CardModel } from '../cards/cardModel.ts';
import type { CanvasSelection } from './canvasState.ts';

/**
 * A level of the document as React Flow elements, derived anew whenever the document changes; elements that come out
 * equal keep their identity and are not re-rendered.
 */
export type CardNode = Node<{ readonly card: CardModel; readonly reach: CanvasPoint }, 'card' | 'dot'>;
export type NoteNode = Node<{ readonly id: string; readonly note: GraphNote }, 'note'>;
export type FrameNode = Node<{ readonly id: string; readonly frame: GraphFrame }, 'frame'>;
export type FlowNode = CardNode | NoteNode | FrameNode;
export type WireEdge = Edge<{ readonly type: string; readonly conflict: boolean }, 'wire'>;

/** Notes and frames are React Flow nodes too; prefixes distinguish their ids. */
const NOTE = 'note:';
const FRAME = 'frame:';

export type FlowItem = { readonly kind: 'node' | 'note' | 'frame'; readonly key: string };

export function flowItem(id: string): FlowItem {
  if (id.startsWith(NOTE)) return { kind: 'note', key: id.slice(NOTE.length) };
  if (id.startsWith(FRAME)) return { kind: 'frame', key: id.slice(FRAME.length) };
  return { kind: 'node', key: id };
}

/** Caches items under what they were made from. */
export class ElementCache<Item> {
  private before = new Map<string, { readonly of: string; readonly item: Item }>();
  private now = new Map<string, { readonly of: string; readonly item: Item }>();

  /** `of`: key of everything that the item depends on. */
  get(id: string, of: string, make: () => Item): Item {
    const before = this.before.get(id);
    const cache = before?.of === of ? before : { of, item: make() };
    this.now.set(id, cache);
    return cache.item;
  }

  /** Drops items that were not requested since the last call. */
  evictUnused(): void {
    this.before = this.now;
    this.now = new Map();
  }
}

export interface FlowInput {
  readonly level: GraphLevel;
  readonly cards: ReadonlyMap<string, CardModel>;
  readonly places: Readonly<Record<string, CanvasPoint>>;
  /** Positions of notes during a drag. */
  readonly notes: Readonly<Record<string, CanvasPoint>>;
  readonly selection: CanvasSelection;
  /** How far titles may extend beyond their nodes (zoomedOutTitle.ts). */
  readonly overhangs: ReadonlyMap<string, CanvasPoint>;
  /** Accessible name of a node. */
  nameOf(card: CardModel): string;
}

/** Z-order: frames, notes, nodes. */
export function flowNodes(input: FlowInput, cache: ElementCache<FlowNode>): FlowNode[] {
  const { level, cards: faces, places, selection, overhangs } = input;
  const boxOf = (id: string): CanvasRect | undefined => {
    const [card, at] = [faces.get(id), places[id]];
    return card && at && { at, size: cardSize(card) };
  };
  const frames = Object.entries(level.graph.frames).flatMap(([key, frame]): FlowNode[] => {
    const box = frameRect(frame, boxOf);
    if (!box) return [];
    const selected = selection.frames.includes(key);
    return [cache.get(FRAME + key, JSON.stringify([frame, box, selected]), () => frameNode(key, frame, box, selected))];
  });
  const notes = Object.entries(level.graph.notes).map(([key, note]): FlowNode => {
    const at = input.notes[key] ?? note.at;
    const selected = selection.notes.includes(key);
    return cache.get(NOTE + key, JSON.stringify([note, at, selected]), () => noteNode(key, note, at, selected));
  });
  const selected = new Set(selection.nodes);
  const cardNodes = [...faces.values()].map((card): FlowNode => {
    const at = places[card.id] ?? [0, 0];
    const isSelected = selected.has(card.id);
    const name = input.nameOf(card);
    const reach = overhangs.get(card.id) ?? [0, 0];
    return cache.get(card.id, JSON.stringify([card, at, isSelected, name, reach]), () => ({
      ...cardNode(card, at, isSelected, reach),
      ariaLabel: name,
    }));
  });
  cache.evictUnused();
  return [...frames, ...notes, ...cardNodes];
}

const sized = ([width, height]: CanvasPoint) => ({ width, height, measured: { width, height } });
const position = ([x, y]: CanvasPoint) => ({ x, y });

const frameNode = (id: string, frame: GraphFrame, { at, size }: CanvasRect, selected: boolean): FrameNode => ({
  id: FRAME + id,
  type: 'frame',
  position: position(at),
  ...sized(size),
  handles: [],
  data: { id, frame },
  selected,
  connectable: false,
  zIndex: -2,
  // Pointer events pass through to what lies in the frame.
  style: { pointerEvents: 'none' },
  dragHandle: '.sl-frame-title',
  ariaLabel: frame.title,
});

const noteNode = (id: string, note: GraphNote, at: CanvasPoint, selected: boolean): NoteNode => ({
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

const cardNode = (card: CardModel, at: CanvasPoint, selected: boolean, reach: CanvasPoint): CardNode => ({
  id: card.id,
  type: card.type === REROUTE ? 'dot' : 'card',
  position: position(at),
  ...sized(cardSize(card)),
  handles: socketPositions(card).map(
    ({ side, socket, at: [x, y] }): NodeHandle => ({
      id: socket.name,
      type: side === 'inputs' ? 'target' : 'source',
      position: side === 'inputs' ? Position.Left : Position.Right,
      // Edges end at the center of the socket mark.
      x: side === 'inputs' ? x : x - SOCKET_SIZE,
      y: y - SOCKET_SIZE / 2,
      width: SOCKET_SIZE,
      height: SOCKET_SIZE,
    }),
  ),
  data: { card, reach },
  selected,
});

export function flowEdges(
  level: GraphLevel,
  types: LevelTypes,
  chosen: CanvasSelection,
  t: Translate,
  cache: ElementCache<WireEdge>,
): WireEdge[] {
  const conflicts = new Set(types.conflicts.map(({ edge }) => edgeKey(edge.to)));
  const edges = Object.entries(level.graph.edges).map(([id, { from, to }]) => {
    const type = types.typeOf(from.node, 'outputs', from.output) ?? 'any';
    const conflict = conflicts.has(id);
    const selected = chosen.edges.includes(id);
    const ariaLabel = t(msg`Connection from ${from.node} to ${to.node}`);
    const make = (): WireEdge => ({
      id,
      type: 'wire',
      source: from.node,
      sourceHandle: from.output,
      target: to.node,
      targetHandle: to.input,
      data: { type, conflict },
      ariaLabel,
      selected,
    });
    return cache.get(id, JSON.stringify([from, type, conflict, selected, ariaLabel]), make);
  });
  cache.evictUnused();
  return edges;
}
