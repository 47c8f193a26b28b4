import type { GraphFrame } from '../../../graph/document/document.ts';
import { REROUTE } from '../../../graph/document/structuralTypes.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import type { CardModel, SocketModel } from './cardModel.ts';

/**
 * How large nodes are and where their sockets lie [px], known without drawing them: layout, alignment and edges need it,
 * and nothing has to be measured. graph.css draws them by the same figures.
 */
export const NODE_WIDTH = 200;
const HEAD_HEIGHT = 30;
const ROW_HEIGHT = 22;
const BODY_PADDING = 5;
const FOOT_HEIGHT = 24;
/** The picture on a node, with what is between it and the node's foot; and below it how its light is spread. */
export const PICTURE_SIZE: CanvasPoint = [NODE_WIDTH - 12, 106];
const PICTURE_FOOT = 6;
const HISTOGRAM_HEIGHT = 44;
/** A bend in an edge. */
const REROUTE_SIZE = 18;
export const SOCKET_SIZE = 12;
/** Where there are no rows to put sockets in, they lie at the middle of the head. */
const IN_HEAD = HEAD_HEIGHT / 2;
/** Below what is in the way of a new node. */
const FREE_GAP = 24;
/** From a frame to what it is around; above there is its title. */
const FRAME_MARGIN = 24;
const FRAME_TITLE = 34;

export function cardSize(face: CardModel): CanvasPoint {
  if (face.type === REROUTE) return [REROUTE_SIZE, REROUTE_SIZE];
  if (face.collapsed) return [NODE_WIDTH, HEAD_HEIGHT];
  const rows = face.rows.length + (face.more > 0 ? 1 : 0);
  const body = rows > 0 ? rows * ROW_HEIGHT + 2 * BODY_PADDING : 0;
  return [NODE_WIDTH, HEAD_HEIGHT + body + pictureHeight(face) + (face.tells ? FOOT_HEIGHT : 0)];
}

const pictureHeight = ({ picture }: CardModel): number =>
  picture ? PICTURE_SIZE[1] + PICTURE_FOOT + (picture === 'metered' ? HISTOGRAM_HEIGHT : 0) : 0;

/** What of a node its title has where it is seen from afar: all, or what is above its picture. */
export function titleArea(face: CardModel, picture: boolean): CanvasPoint {
  const [width, height] = cardSize(face);
  return [width, picture && !face.collapsed ? height - pictureHeight(face) : height];
}

/** A socket with the middle of its mark, from the node's corner [px]. */
interface SocketPosition {
  readonly side: 'inputs' | 'outputs';
  readonly socket: SocketModel;
  readonly at: CanvasPoint;
}

export function socketPositions(face: CardModel): SocketPosition[] {
  const [width, height] = cardSize(face);
  const heightOf = (row: number): number => {
    if (face.type === REROUTE) return height / 2;
    return face.collapsed ? IN_HEAD : HEAD_HEIGHT + BODY_PADDING + (row + 0.5) * ROW_HEIGHT;
  };
  const inset = face.type === REROUTE ? REROUTE_SIZE / 2 : 0;
  return face.rows.flatMap(({ input, output }, row): SocketPosition[] => [
    ...(input ? [{ side: 'inputs' as const, socket: input, at: [inset, heightOf(row)] as const }] : []),
    ...(output ? [{ side: 'outputs' as const, socket: output, at: [width - inset, heightOf(row)] as const }] : []),
  ]);
}

/** A rectangle on the canvas [px]. */
export interface CanvasRect {
  readonly at: CanvasPoint;
  readonly size: CanvasPoint;
}

/** What holds all of some boxes; undefined of none. */
export function boundingRect(boxes: readonly CanvasRect[]): CanvasRect | undefined {
  if (boxes.length === 0) return undefined;
  const least = (axis: 0 | 1) => Math.min(...boxes.map(({ at }) => at[axis]));
  const most = (axis: 0 | 1) => Math.max(...boxes.map(({ at, size }) => at[axis] + size[axis]));
  const at: CanvasPoint = [least(0), least(1)];
  return { at, size: [most(0) - at[0], most(1) - at[1]] };
}

/** Where a frame is drawn; undefined where it has nothing in it. */
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

/** Nodes whose pictures would cover another node go without. */
export function withoutCoveringPictures(
  faces: ReadonlyMap<string, CardModel>,
  places: Readonly<Record<string, CanvasPoint>>,
): ReadonlyMap<string, CardModel> {
  const bare = [...faces.values()].map(({ picture: _, ...face }): { face: CardModel; box: CanvasRect } => ({
    face,
    box: { at: places[face.id] ?? [0, 0], size: cardSize(face) },
  }));
  return new Map(
    bare.map(({ face, box: { at, size } }) => {
      const whole = faces.get(face.id)!;
      const picture: CanvasRect = { at: [at[0], at[1] + size[1]], size: [size[0], cardSize(whole)[1] - size[1]] };
      const covers = whole.picture && bare.some((other) => other.face !== face && rectsOverlap(picture, other.box));
      return [face.id, covers ? face : whole];
    }),
  );
}

/** A place that nothing covers, straight below a wanted one or at it. */
export function freePosition(wanted: CanvasPoint, size: CanvasPoint, boxes: readonly CanvasRect[]): CanvasPoint {
  const [x] = wanted;
  let [, y] = wanted;
  const covers = (box: CanvasRect): boolean => rectsOverlap(box, { at: [x, y], size });
  for (let box = boxes.find(covers); box; box = boxes.find(covers)) y = box.at[1] + box.size[1] + FREE_GAP;
  return [x, y];
}
