import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { formatBytes } from '../diagnostics/inputError.ts';
import type { RandomAccessFile } from '../zip/directory.ts';
import { type Mp4Header, readMp4Header } from './mp4Boxes.ts';

/** Largest box that is read [bytes], and most boxes of a file. */
const MAX_CONTENT = 2 ** 26;
const MAX_FILE_BOXES = 10_000;
/** Smallest box [bytes]. */
const MIN_BOX = 8;

/** A box of an MP4 file, outside of others. */
export interface FileBox extends Mp4Header {
  /** In the file [bytes]. */
  readonly at: number;
}

/** The boxes of an MP4 file. Throws a MessageError where one leaves it. */
export async function* fileBoxes(file: RandomAccessFile): AsyncGenerator<FileBox> {
  let at = 0;
  for (let count = 0; at + MIN_BOX <= file.size; count++) {
    if (count >= MAX_FILE_BOXES) throw new MessageError(msg`there are more than ${MAX_FILE_BOXES} boxes`);
    const header = readMp4Header(await file.read(at, Math.min(at + 2 * MIN_BOX, file.size)), '', at);
    const size = header.size || file.size - at;
    if (at + size > file.size)
      throw new MessageError(
        msg`${header.type} at byte ${at} claims ${size} bytes of the ${file.size - at} that are left`,
      );
    yield { ...header, size, at };
    at += size;
  }
}

/** What a box contains. Throws a MessageError where it is too large to be read. */
export async function readContent(file: RandomAccessFile, { type, at, header, size }: FileBox): Promise<Uint8Array> {
  if (size > MAX_CONTENT)
    throw new MessageError(msg`${type} has ${formatBytes(size)}; at most ${formatBytes(MAX_CONTENT)} are read`);
  return file.read(at + header, at + size);
}
