import { Inflate } from 'fflate';
import { type Message, msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { crc32 } from '../files/crc32.ts';
import { dataStart, LOCAL_SIZE, type RandomAccessFile, type ZipEntry } from './directory.ts';

/** Chunk size of inflation [bytes]: limits the excess of a file larger than declared, 1032-fold. */
const PORTION = 2 ** 14;

/** Unpacks one file of an archive. Throws an InputError where it contradicts the directory. */
export async function unpack(archive: RandomAccessFile, entry: ZipEntry, name: string): Promise<Uint8Array> {
  const { path, method, packed, size, crc, offset } = entry;
  const fail = (message: Message, cause?: unknown): never => {
    throw inputError('zip.damaged', name, msg`${path} in it ${message}; copy or pack it again`, cause);
  };
  if (offset + LOCAL_SIZE > archive.size) fail(msg`is cut off`);
  const from = dataStart(await archive.read(offset, offset + LOCAL_SIZE), entry, name);
  if (from + packed > archive.size) fail(msg`is cut off`);
  const bytes = await archive.read(from, from + packed);
  if (method !== 0 && method !== 8) {
    const message = msg`${path} in it is packed by method ${method}, which is not read; pack it as a plain zip (deflate)`;
    throw inputError('zip.method', name, message);
  }
  const out = method === 0 ? bytes : inflated(bytes, size, fail);
  if (out.length !== size) fail(msg`has ${out.length} bytes, not the ${size} that the directory says`);
  if (crc32(out) !== crc) fail(msg`is damaged: its check sum is another`);
  return out;
}

function inflated(bytes: Uint8Array, size: number, fail: (message: Message, cause?: unknown) => never): Uint8Array {
  const out = new Uint8Array(size);
  let made = 0;
  const inflate = new Inflate((part) => {
    if (made + part.length > size) fail(msg`holds more than the ${size} bytes that the directory says`);
    out.set(part, made);
    made += part.length;
  });
  try {
    for (let at = 0; at < bytes.length || at === 0; at += PORTION)
      inflate.push(bytes.subarray(at, at + PORTION), at + PORTION >= bytes.length);
  } catch (thrown) {
    if (thrown instanceof Error && 'diagnostic' in thrown) throw thrown;
    fail(msg`cannot be unpacked (${messageOf(thrown)})`, thrown);
  }
  return out.subarray(0, made);
}
