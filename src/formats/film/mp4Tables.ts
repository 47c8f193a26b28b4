import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { fileBoxes, readContent } from '../spherical/fileBoxes.ts';
import { type Mp4Box, readMp4Boxes } from '../spherical/mp4Boxes.ts';
import { NO_MOOV } from '../spherical/sphericalMp4.ts';
import type { RandomAccessFile } from '../zip/directory.ts';

/** Most samples of a film: frames, and packets of sound. */
const MAX_SAMPLES = 2 ** 22;

/** First boxes of MP4 and QuickTime. */
const FIRST_BOXES = ['ftyp', 'moov', 'mdat', 'wide', 'free', 'skip'];

/** Where tables of samples are. */
const TABLES = ['trak', 'mdia', 'minf', 'stbl'];
const FRAGMENTS = ['traf'];

/**
 * Checks the tables of an MP4 or QuickTime film before they are followed, since a count that one damaged bit makes huge takes minutes and all memory. Other files pass. Throws a
 * MessageError with the place.
 */
export async function checkMp4Tables(file: RandomAccessFile): Promise<void> {
  const head = await file.read(0, Math.min(file.size, 8));
  if (!FIRST_BOXES.includes(String.fromCharCode(...head.subarray(4, 8)))) return;
  let hasMoov = false;
  let samples = 0;
  for await (const box of fileBoxes(file)) {
    hasMoov ||= box.type === 'moov';
    if (box.type !== 'moov' && box.type !== 'moof') continue;
    samples += samplesIn(await readContent(file, box), box.type, box.type === 'moov' ? TABLES : FRAGMENTS);
    checkCount(samples, box.type);
  }
  if (!hasMoov) throw new MessageError(NO_MOOV);
}

/** The samples that the tables on a path of boxes claim. */
function samplesIn(content: Uint8Array, place: string, [type, ...inner]: readonly string[]): number {
  const { boxes } = readMp4Boxes(content, place);
  if (type === undefined) return checkedTables(boxes, place);
  const parts = boxes.map((box) => (box.type === type ? samplesIn(box.content, `${place}/${type}`, inner) : 0));
  return parts.reduce((sum, part) => sum + part, 0);
}

/** The samples of a track or a fragment; what other tables say of them is checked (ISO/IEC 14496-12, 8.6.1, 8.7, 8.8.8). */
function checkedTables(boxes: readonly Mp4Box[], place: string): number {
  let samples = 0;
  for (const { type, content } of boxes) {
    const table = new NumberTable(content, `${place}/${type}`);
    if (type === 'trun') samples += table.number(4);
    else if (type === 'stsz' || type === 'stz2') samples += sizes(table);
    else if (type === 'stts' || type === 'ctts') checkCount(runs(table), table.place);
    else if (type === 'stsc') checkCount(inChunks(table, chunkCount(boxes, place)), table.place);
  }
  return samples;
}

/** How many samples have sizes: one for all, or a list of 32 bits each. */
function sizes(table: NumberTable): number {
  const count = table.number(8);
  checkCount(count, table.place);
  if (count > 0 && table.number(4) === 0) table.number(12 + 4 * (count - 1));
  return count;
}

/** How many samples are in runs of one time each. */
const runs = (table: NumberTable): number => table.entries(2).reduce((sum, [count]) => sum + count!, 0);

/** How many samples are in chunks, by runs of chunks that have as many each. */
const inChunks = (table: NumberTable, chunks: number): number =>
  table
    .entries(3)
    .reduce((sum, [first, each], i, all) => sum + Math.max(0, (all[i + 1]?.[0] ?? chunks + 1) - first!) * each!, 0);

function chunkCount(boxes: readonly Mp4Box[], place: string): number {
  const box = boxes.find(({ type }) => type === 'stco' || type === 'co64');
  return box ? new NumberTable(box.content, `${place}/${box.type}`).entries(box.type === 'stco' ? 1 : 2).length : 0;
}

/** Numbers of 32 bits. */
class NumberTable {
  readonly place: string;
  private readonly view: DataView;

  constructor({ buffer, byteOffset, byteLength }: Uint8Array, place: string) {
    this.place = place;
    this.view = new DataView(buffer, byteOffset, byteLength);
  }

  number(at: number): number {
    if (at + 4 > this.view.byteLength) throw new MessageError(msg`${this.place} ends before its byte ${at + 4}`);
    return this.view.getUint32(at);
  }

  /** Entries of so many numbers each, behind their count. */
  entries(size: number): number[][] {
    const count = this.number(4);
    if (count > 0) this.number(8 + 4 * (size * count - 1));
    return Array.from({ length: count }, (_, i) =>
      Array.from({ length: size }, (__, k) => this.number(8 + 4 * (size * i + k))),
    );
  }
}

function checkCount(count: number, place: string): void {
  if (count > MAX_SAMPLES) throw new MessageError(msg`${place} claims ${count} samples, more than a film can have`);
}
