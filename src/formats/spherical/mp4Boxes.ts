import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { joinedBytes } from '../files/joinedBytes.ts';

/** A box of an MP4 (ISO/IEC 14496-12, 4.2): a type and what it contains. */
export interface Mp4Box {
  /** Four characters, Latin-1. */
  readonly type: string;
  /** Without size and type. */
  readonly content: Uint8Array;
  /** Its size is written in 64 bits. */
  readonly isWide?: boolean;
}

/** The boxes that fill a box, and bytes behind them that are too few for one: QuickTime ends some lists with zeros. */
export interface Mp4Boxes {
  /** In the order of the file. */
  readonly boxes: readonly Mp4Box[];
  /** 0 … 7 bytes. */
  readonly rest: Uint8Array;
}

/** Size of a box's header [bytes]: size and type; with a size in 64 bits. */
const [HEADER, WIDE_HEADER] = [8, 16];
/** Boxes in one box that are read: a bound on memory. */
const MAX_BOXES = 100_000;

/** A header of a box. */
export interface Mp4Header {
  /** Four characters, Latin-1. */
  readonly type: string;
  /** Of the header itself [bytes]. */
  readonly header: number;
  /** Of the whole box [bytes]; 0: up to the end of the file. */
  readonly size: number;
}

/** The header at the start of `bytes`, which are 16 or as many as there are, at least 8. For messages: the path before it, and where it is. */
export function readMp4Header(bytes: Uint8Array, path: string, at: number): Mp4Header {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const type = String.fromCharCode(...bytes.subarray(4, HEADER));
  const short = view.getUint32(0);
  const isWide = short === 1;
  if (isWide && bytes.length < WIDE_HEADER)
    throw new MessageError(msg`the header of ${path + type} at byte ${at} is cut off`);
  const [size, header] = isWide ? [Number(view.getBigUint64(HEADER)), WIDE_HEADER] : [short, HEADER];
  if (size < header && short !== 0)
    throw new MessageError(msg`${path + type} at byte ${at} claims ${size} bytes, less than its header has`);
  return { type, header, size };
}

/** The boxes in the content of the box `place`. Throws where one leaves it. */
export function readMp4Boxes(content: Uint8Array, place: string): Mp4Boxes {
  const boxes: Mp4Box[] = [];
  let at = 0;
  while (at + HEADER <= content.length) {
    const { type, header, size } = readMp4Header(content.subarray(at, at + WIDE_HEADER), `${place}/`, at);
    if (size === 0 || at + size > content.length)
      throw new MessageError(
        msg`${`${place}/${type}`} at byte ${at} claims ${size} bytes of the ${content.length - at} that are left`,
      );
    if (boxes.length >= MAX_BOXES) throw new MessageError(msg`${place} has more than ${MAX_BOXES} boxes`);
    const isWide = header === WIDE_HEADER;
    boxes.push({ type, content: content.subarray(at + header, at + size), ...(isWide && { isWide }) });
    at += size;
  }
  return { boxes, rest: content.subarray(at) };
}

/** The inverse of `readMp4Boxes`. */
export const writeMp4Boxes = ({ boxes, rest }: Mp4Boxes): Uint8Array =>
  joinedBytes([...boxes.flatMap((box) => [boxHeader(box), box.content]), rest]);

/** The bytes of a box. */
export function mp4Box(type: string, ...content: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const joined = joinedBytes(content);
  return joinedBytes([mp4Header(type, mp4BoxSize(joined)), joined]);
}

/** Of the box with a content [bytes]. */
export const mp4BoxSize = (content: Uint8Array): number => HEADER + content.length;

const boxHeader = ({ type, content, isWide }: Mp4Box): Uint8Array =>
  mp4Header(type, (isWide ? WIDE_HEADER : HEADER) + content.length, isWide);

/** The header of a box of a size [bytes]. */
export function mp4Header(type: string, size: number, isWide = false): Uint8Array {
  const header = new Uint8Array(isWide ? WIDE_HEADER : HEADER);
  const view = new DataView(header.buffer);
  view.setUint32(0, isWide ? 1 : size);
  for (let i = 0; i < 4; i++) header[4 + i] = type.charCodeAt(i);
  if (isWide) view.setBigUint64(HEADER, BigInt(size));
  return header;
}

/** Boxes of one kind: which types lead to them from the box that holds all. */
export type Mp4Path = readonly string[];

/** The contents of all boxes on a path. */
export function contentsAt(content: Uint8Array, path: Mp4Path, place: string): Uint8Array[] {
  const [type, ...inner] = path;
  if (type === undefined) return [content];
  const found = readMp4Boxes(content, place).boxes.filter((box) => box.type === type);
  return found.flatMap((box) => contentsAt(box.content, inner, `${place}/${type}`));
}

/** The content with what is in each box on a path changed, and the sizes of all that hold these. */
export function changedAt(
  content: Uint8Array,
  path: Mp4Path,
  place: string,
  change: (content: Uint8Array, place: string) => Uint8Array,
): Uint8Array {
  const [type, ...inner] = path;
  if (type === undefined) return change(content, place);
  const { boxes, rest } = readMp4Boxes(content, place);
  const changed = boxes.map((box) =>
    box.type === type ? { ...box, content: changedAt(box.content, inner, `${place}/${type}`, change) } : box,
  );
  return writeMp4Boxes({ boxes: changed, rest });
}
