import type { Point } from '../../graph/commands.ts';
import type { Frame } from '../../graph/document.ts';
import { REROUTE } from '../../graph/structure.ts';
import type { Face, SocketFace } from './face.ts';

/**
 * How large nodes are and where their sockets lie [px], known without drawing them: layout, alignment and edges need it,
 * and nothing has to be measured. graph.css draws them by the same figures.
 */
export const NODE_WIDTH = 200;
const HEAD = 30;
const ROW = 22;
const PAD = 5;
const FOOT = 24;
/** The picture on a node, with what is between it and the node's foot; and below it how its light is spread. */
export const PICTURE: Point = [NODE_WIDTH - 12, 106];
const PICTURE_FOOT = 6;
const SPREAD = 44;
/** A bend in an edge. */
const DOT = 18;
export const SOCKET = 12;
/** Where there are no rows to put sockets in, they lie at the middle of the head. */
const IN_HEAD = HEAD / 2;
/** Below what is in the way of a new node. */
const FREE = 24;
/** From a frame to what it is around; above there is its title. */
const FRAME_MARGIN = 24;
const FRAME_TITLE = 34;

export function sizeOf(face: Face): Point {
  if (face.type === REROUTE) return [DOT, DOT];
  if (face.collapsed) return [NODE_WIDTH, HEAD];
  const rows = face.rows.length + (face.more > 0 ? 1 : 0);
  const body = rows > 0 ? rows * ROW + 2 * PAD : 0;
  return [NODE_WIDTH, HEAD + body + pictureHeight(face) + (face.tells ? FOOT : 0)];
}

const pictureHeight = ({ picture }: Face): number =>
  picture ? PICTURE[1] + PICTURE_FOOT + (picture === 'metered' ? SPREAD : 0) : 0;

/** What of a node its title has where it is seen from afar: all, or what is above its picture. */
export function titleRoom(face: Face, picture: boolean): Point {
  const [width, height] = sizeOf(face);
  return [width, picture && !face.collapsed ? height - pictureHeight(face) : height];
}

/** A socket with the middle of its mark, from the node's corner [px]. */
interface SocketPlace {
  readonly side: 'inputs' | 'outputs';
  readonly socket: SocketFace;
  readonly at: Point;
}

export function socketPlaces(face: Face): SocketPlace[] {
  const [width, height] = sizeOf(face);
  const heightOf = (row: number): number => {
    if (face.type === REROUTE) return height / 2;
    return face.collapsed ? IN_HEAD : HEAD + PAD + (row + 0.5) * ROW;
  };
  const inset = face.type === REROUTE ? DOT / 2 : 0;
  return face.rows.flatMap(({ input, output }, row): SocketPlace[] => [
    ...(input ? [{ side: 'inputs' as const, socket: input, at: [inset, heightOf(row)] as const }] : []),
    ...(output ? [{ side: 'outputs' as const, socket: output, at: [width - inset, heightOf(row)] as const }] : []),
  ]);
}

/** A rectangle on the canvas [px]. */
export interface Box {
  readonly at: Point;
  readonly size: Point;
}

/** What holds all of some boxes; undefined of none. */
export function around(boxes: readonly Box[]): Box | undefined {
  if (boxes.length === 0) return undefined;
  const least = (axis: 0 | 1) => Math.min(...boxes.map(({ at }) => at[axis]));
  const most = (axis: 0 | 1) => Math.max(...boxes.map(({ at, size }) => at[axis] + size[axis]));
  const at: Point = [least(0), least(1)];
  return { at, size: [most(0) - at[0], most(1) - at[1]] };
}

/** Where a frame is drawn; undefined where it has nothing in it. */
export function frameBox({ nodes }: Frame, boxOf: (node: string) => Box | undefined): Box | undefined {
  const held = around(nodes.flatMap((node) => boxOf(node) ?? []));
  if (!held) return undefined;
  const [x, y] = held.at;
  const [width, height] = held.size;
  return {
    at: [x - FRAME_MARGIN, y - FRAME_TITLE],
    size: [width + 2 * FRAME_MARGIN, height + FRAME_TITLE + FRAME_MARGIN],
  };
}

const overlap = (a: Box, b: Box): boolean =>
  [0, 1].every((axis) => a.at[axis]! < b.at[axis]! + b.size[axis]! && b.at[axis]! < a.at[axis]! + a.size[axis]!);

/** Nodes whose pictures would cover another node go without. */
export function withRoom(
  faces: ReadonlyMap<string, Face>,
  places: Readonly<Record<string, Point>>,
): ReadonlyMap<string, Face> {
  const bare = [...faces.values()].map(({ picture: _, ...face }): { face: Face; box: Box } => ({
    face,
    box: { at: places[face.id] ?? [0, 0], size: sizeOf(face) },
  }));
  return new Map(
    bare.map(({ face, box: { at, size } }) => {
      const whole = faces.get(face.id)!;
      const picture: Box = { at: [at[0], at[1] + size[1]], size: [size[0], sizeOf(whole)[1] - size[1]] };
      const covers = whole.picture && bare.some((other) => other.face !== face && overlap(picture, other.box));
      return [face.id, covers ? face : whole];
    }),
  );
}

/** A place that nothing covers, straight below a wanted one or at it. */
export function freePlace(wanted: Point, size: Point, boxes: readonly Box[]): Point {
  const [x] = wanted;
  let [, y] = wanted;
  const covers = (box: Box): boolean => overlap(box, { at: [x, y], size });
  for (let box = boxes.find(covers); box; box = boxes.find(covers)) y = box.at[1] + box.size[1] + FREE;
  return [x, y];
}
