import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { joinedBytes } from '../files/joinedBytes.ts';
import { changedAt, contentsAt, type Mp4Box, mp4BoxSize, readMp4Boxes, writeMp4Boxes } from './mp4Boxes.ts';

const SAMPLE_TABLE = ['trak', 'mdia', 'minf', 'stbl'];
const TABLE_PLACE = ['moov', ...SAMPLE_TABLE].join('/');
/** Bytes before the offsets: version, flags and count (ISO/IEC 14496-12, 8.7.5). */
const TABLE_HEADER = 8;
const MAX_U32 = 2 ** 32 - 1;

/** What of a file is replaced, so that all behind it moves [bytes]. */
export interface FileCut {
  /** Where it begins. */
  readonly from: number;
  /** Where it ends. */
  readonly to: number;
}

/** The places of all chunks in the file [bytes], in the order of the tables in the content of `moov`. */
const chunkOffsets = (moov: Uint8Array): number[] =>
  contentsAt(moov, SAMPLE_TABLE, 'moov').flatMap((table) =>
    readMp4Boxes(table, TABLE_PLACE).boxes.flatMap((box) => (isChunkTable(box) ? offsetsIn(box) : [])),
  );

const isChunkTable = ({ type }: Mp4Box): boolean => type === 'stco' || type === 'co64';

function offsetsIn({ type, content }: Mp4Box): number[] {
  const width = widthOf(type);
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const count = content.length < TABLE_HEADER ? Number.POSITIVE_INFINITY : view.getUint32(4);
  if (TABLE_HEADER + count * width > content.length)
    throw new MessageError(
      msg`${`${TABLE_PLACE}/${type}`} has ${content.length} bytes, less than ${TABLE_HEADER + count * width}`,
    );
  return Array.from({ length: count }, (_, i) =>
    width === 8 ? Number(view.getBigUint64(TABLE_HEADER + 8 * i)) : view.getUint32(TABLE_HEADER + 4 * i),
  );
}

/** Throws where a chunk is inside the part of the file that is replaced. */
export function checkChunks(moov: Uint8Array, { from, to }: FileCut): void {
  const inside = chunkOffsets(moov).find((offset) => offset >= from && offset < to);
  if (inside !== undefined) throw new MessageError(msg`a chunk is at byte ${inside}, inside moov or free space`);
}

/**
 * The content of `moov` whose box replaces a part of its file: chunks behind the part have moved by as much as the box is
 * longer. Offsets become 64 bits wide in all tables where one of them no longer fits into 32.
 */
export function withMovedChunks(moov: Uint8Array, { from, to }: FileCut): Uint8Array {
  const highest = chunkOffsets(moov).reduce((most, offset) => Math.max(most, offset), 0);
  const fits = highest + mp4BoxSize(moov) - (to - from) <= MAX_U32;
  const prepared = fits ? moov : withWideOffsets(moov);
  const move = mp4BoxSize(prepared) - (to - from);
  return changedTables(prepared, (box) => withOffsets(box, moved(offsetsIn(box), to, move)));
}

const moved = (offsets: readonly number[], from: number, move: number): number[] =>
  offsets.map((offset) => (offset >= from ? offset + move : offset));

const withWideOffsets = (moov: Uint8Array): Uint8Array =>
  changedTables(moov, (box) => withOffsets(box, offsetsIn(box), 'co64'));

const changedTables = (moov: Uint8Array, change: (box: Mp4Box) => Mp4Box): Uint8Array =>
  changedAt(moov, SAMPLE_TABLE, 'moov', (table, at) => {
    const { boxes, rest } = readMp4Boxes(table, at);
    const positions = boxes.find(({ type }) => type === 'saio');
    if (positions) throw uncorrected(`${at}/saio`);
    return writeMp4Boxes({ boxes: boxes.map((box) => (isChunkTable(box) ? change(box) : box)), rest });
  });

/** A box with positions in the file that would become wrong. */
export const uncorrected = (box: string): MessageError =>
  new MessageError(
    msg`its box ${box} holds positions in the file, which are not corrected; save it with moov at its end`,
  );

/** The table with other offsets, as many, of a type that may be wider. */
function withOffsets(box: Mp4Box, offsets: readonly number[], type = box.type): Mp4Box {
  const numbers = new Uint8Array(offsets.length * widthOf(type));
  const view = new DataView(numbers.buffer);
  for (const [i, offset] of offsets.entries())
    if (type === 'co64') view.setBigUint64(8 * i, BigInt(offset));
    else view.setUint32(4 * i, offset);
  const rest = box.content.subarray(TABLE_HEADER + offsets.length * widthOf(box.type));
  return { ...box, type, content: joinedBytes([box.content.subarray(0, TABLE_HEADER), numbers, rest]) };
}

/** Of one offset [bytes]. */
const widthOf = (type: string): number => (type === 'co64' ? 8 : 4);
