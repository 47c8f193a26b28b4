import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { joinedBytes } from '../files/joinedBytes.ts';
import type { RandomAccessFile } from '../zip/directory.ts';
import { memoryFile } from '../zip/zipSource.ts';
import { checkChunks, uncorrected, withMovedChunks } from './chunkOffsets.ts';
import { type FileBox, fileBoxes, readContent } from './fileBoxes.ts';
import { inFile } from './inFile.ts';
import { mp4Box, mp4Header } from './mp4Boxes.ts';
import { sphericalOfMoov, withSphericalBoxes } from './sphericalMoov.ts';

/** One change of a file: `removed` bytes from `at` give way to `bytes`, and what follows stays as it is. */
export interface FileEdit {
  /** Where [bytes]. */
  readonly at: number;
  /** How many are replaced [bytes]; as many as `bytes` where nothing behind them moves. */
  readonly removed: number;
  /** What is there afterwards. */
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** Smallest box, and largest free one that is used [bytes]. */
const MIN_BOX = 8;
const MAX_FREE = 2 ** 31;

/**
 * How to mark an MP4 film as spherical, after Spherical Video V2 and, for equirectangular pictures, V1. Only its `moov`
 * is read, so films may be larger than memory. Where free space follows `moov`, or it is the end of the file, nothing else
 * moves; else the edit corrects the places of all chunks behind it. Marks that the film has are replaced.
 * Throws a MessageError with name and place for damaged films and fragmented ones.
 * @example
 * // With a film on disk; the edit is short, whatever the film's size.
 * async function mark(film: RandomAccessFile): Promise<number> {
 *   const edit = await sphericalMp4Edit(film, 'film.mp4', { projection: 'equirectangular', stereo: 'none' });
 *   return edit.at; // where edit.bytes take the place of edit.removed bytes
 * }
 */
export const sphericalMp4Edit = (file: RandomAccessFile, name: string, picture: SphericalPicture): Promise<FileEdit> =>
  inFile(name, async () => {
    const { moov, room, isLast, hasMeta } = await findMoov(file);
    const { at } = moov;
    const marked = withSphericalBoxes(await readContent(file, moov), picture);
    const replaced = { from: at, to: at + room };
    checkChunks(marked, replaced);
    const bytes = mp4Box('moov', marked);
    const free = room - bytes.length;
    if (isLast || free === 0) return { at, removed: room, bytes };
    if (free >= MIN_BOX) {
      const withFree = joinedBytes([bytes, mp4Header('free', free)]);
      return { at, removed: withFree.length, bytes: withFree };
    }
    if (hasMeta) throw uncorrected('meta');
    return { at, removed: room, bytes: mp4Box('moov', withMovedChunks(marked, replaced)) };
  });

/**
 * A film in memory, marked as spherical: `sphericalMp4Edit` carried out.
 * @example
 * // With a film; `mp4` has its bytes.
 * const mark = (mp4: Uint8Array) =>
 *   withSphericalMp4(mp4, 'film.mp4', { projection: 'equirectangular', stereo: 'top-bottom' });
 */
export async function withSphericalMp4(
  bytes: Uint8Array,
  name: string,
  picture: SphericalPicture,
): Promise<Uint8Array<ArrayBuffer>> {
  const edit = await sphericalMp4Edit(memoryFile(bytes), name, picture);
  return joinedBytes([bytes.subarray(0, edit.at), edit.bytes, bytes.subarray(edit.at + edit.removed)]);
}

/** What a film says; undefined where it says nothing. Fragmented ones are read too. Throws where it is damaged. */
export async function sphericalOfMp4(file: RandomAccessFile): Promise<SphericalPicture | undefined> {
  for await (const box of fileBoxes(file))
    if (box.type === 'moov') return sphericalOfMoov(await readContent(file, box));
  throw new MessageError(NO_MOOV);
}

export const NO_MOOV = msg`there is no moov box: the film is cut off, or was never finished`;

async function findMoov(file: RandomAccessFile) {
  const boxes: FileBox[] = [];
  for await (const box of fileBoxes(file)) {
    if (box.type === 'moof') throw fragmented();
    boxes.push(box);
  }
  const [index, second] = boxes.flatMap(({ type }, i) => (type === 'moov' ? [i] : []));
  if (index === undefined) throw new MessageError(NO_MOOV);
  if (second !== undefined)
    throw new MessageError(msg`there are two moov boxes, at byte ${boxes[index].at} and ${boxes[second].at}`);
  const moov = boxes[index];
  const next = boxes[index + 1];
  const isFree = (next?.type === 'free' || next?.type === 'skip') && next.size <= MAX_FREE;
  const room = moov.size + (isFree ? next.size : 0);
  const hasMeta = boxes.some(({ type }) => type === 'meta');
  return { moov, room, isLast: moov.at + room === file.size, hasMeta };
}

const fragmented = (): MessageError =>
  new MessageError(msg`the film is fragmented, which cannot be marked; save it without fragments`);
