import type { GraphFrame } from '../../../graph/document/document.ts';
import { REROUTE } from '../../../graph/document/structuralTypes.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import type { CardModel, SocketModel } from './cardModel.ts';

/**
 * Sizes of nodes and positions of their sockets [px], computed without rendering, for layout, alignment and edges.
 * graph.css draws with the same figures.
 */
export const NODE_WIDTH = 200;
const HEAD_HEIGHT = 30;
const ROW_HEIGHT = 22;
const BODY_PADDING = 5;
const FOOT_HEIGHT = 24;
/** Size of a node's picture, with the space below it; and of the luminance histogram below that. */
export const PICTURE_SIZE: CanvasPoint = [NODE_WIDTH - 12, 106];
const PICTURE_FOOT = 6;
const HISTOGRAM_HEIGHT = 44;
/** Size of a reroute. */
const REROUTE_SIZE = 18;
export const SOCKET_SIZE = 12;
/** Nodes without rows have their sockets at mid-height of the header. */
const IN_HEAD = HEAD_HEIGHT / 2;
/** Distance of a new node below the nodes that it would cover. */
const FREE_GAP = 24;
/** Margin between a frame and its content; the title is above. */
const FRAME_MARGIN = 24;
const FRAME_TITLE = 34;

export function cardSize(card: CardModel): CanvasPoint {
  if (card.type === REROUTE) return [REROUTE_SIZE, REROUTE_SIZE];
  if (card.collapsed) return [NODE_WIDTH, HEAD_HEIGHT];
  const rows = card.rows.length + (card.more > 0 ? 1 : 0);
  const body = rows > 0 ? rows * ROW_HEIGHT + 2 * BODY_PADDING : 0;
  return [NODE_WIDTH, HEAD_HEIGHT + body + pictureHeight(card) + (card.hasPreview ? FOOT_HEIGHT : 0)];
}

const pictureHeight = ({ picture }: CardModel): number =>
  picture ? PICTURE_SIZE[1] + PICTURE_FOOT + (picture === 'metered' ? HISTOGRAM_HEIGHT : 0) : 0;

/** Area for the title of a zoomed-out node: the whole card, or what is above its picture. */
export function titleArea(card: CardModel, picture: boolean): CanvasPoint {
  const [width, height] = cardSize(card);
  return [width, picture && !card.collapsed ? height - pictureHeight(card) : height];
}

/** A socket with the center of its mark, relative to the node's corner [px]. */
interface SocketPosition {
  readonly side: 'inputs' | 'outputs';
  readonly socket: SocketModel;
  readonly at: CanvasPoint;
}

export function socketPositions(card: CardModel): SocketPosition[] {
  const [width, height] = cardSize(card);
  const heightOf = (row: number): number => {
    if (card.type === REROUTE) return height / 2;
    return card.collapsed ? IN_HEAD : HEAD_HEIGHT + BODY_PADDING + (row + 0.5) * ROW_HEIGHT;
  };
  const inset = card.type === REROUTE ? REROUTE_SIZE / 2 : 0;
  return card.rows.flatMap(({ input, output }, row): SocketPosition[] => [
    ...(input ? [{ side: 'inputs' as const, socket: input, at: [inset, heightOf(row)] as const }] : []),
    ...(output ? [{ side: 'outputs' as const, socket: output, at: [width - inset, heightOf(row)] as const }] : []),
  ]);
}

/** A rectangle on the canvas [px]. */
export interface CanvasRect {
  readonly at: CanvasPoint;
  readonly size: CanvasPoint;
}

/** Bounding rectangle; undefined for none. */
export function boundingRect(boxes: readonly CanvasRect[]): CanvasRect | undefined {
  if (boxes.length === 0) return undefined;
  const least = (axis: 0 | 1) => Math.min(...boxes.map(({ at }) => at[axis]));
  const most = (axis: 0 | 1) => Math.max(...boxes.map(({ at, size }) => at[axis] + size[axis]));
  const at: CanvasPoint = [least(0), least(1)];
  return { at, size: [most(0) - at[0], most(1) - at[1]] };
}

/** Rectangle of a frame; undefined if the frame is empty. */
export function frameRect(
  { nodes }: GraphFrame,
  boxOf: (node: string) => CanvasRect | undefined,
): CanvasRect | undefined {
  const held = boundingRect(nodes.flatMap((node) => boxOf(node) ?? []));
  if (!held) return undefined;
  const [x, y] = held.at;
  const [width, height] = held.size;
  return {
    at: [x - FRAME_MARGIN, y - FRAME_TITLE],
    size: [width + 2 * FRAME_MARGIN, height + FRAME_TITLE + FRAME_MARGIN],
  };
}

const rectsOverlap = (a: CanvasRect, b: CanvasRect): boolean =>
  [0, 1].every((axis) => a.at[axis]! < b.at[axis]! + b.size[axis]! && b.at[axis]! < a.at[axis]! + a.size[axis]!);

/** Card models, without pictures that would cover another node. */
export function withoutCoveringPictures(
  cards: ReadonlyMap<string, CardModel>,
  places: Readonly<Record<string, CanvasPoint>>,
): ReadonlyMap<string, CardModel> {
  const bare = [...cards.values()].map(({ picture: _, ...card }): { card: CardModel; box: CanvasRect } => ({
    card,
    box: { at: places[card.id] ?? [0, 0], size: cardSize(card) },
  }));
  return new Map(
    bare.map(({ card, box: { at, size } }) => {
      const uncropped = cards.get(card.id)!;
      const picture: CanvasRect = { at: [at[0], at[1] + size[1]], size: [size[0], cardSize(uncropped)[1] - size[1]] };
      const covers = uncropped.picture && bare.some((other) => other.card !== card && rectsOverlap(picture, other.box));
      return [card.id, covers ? card : uncropped];
    }),
  );
}

/** The first free position at or straight below the wanted one. */
export function freePosition(wanted: CanvasPoint, size: CanvasPoint, boxes: readonly CanvasRect[]): CanvasPoint {
  const [x] = wanted;
  let [, y] = wanted;
  const covers = (box: CanvasRect): boolean => rectsOverlap(box, { at: [x, y], size });
  for (let box = boxes.find(covers); box; box = boxes.find(covers)) y = box.at[1] + box.size[1] + FREE_GAP;
  return [x, y];
}
