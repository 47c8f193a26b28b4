import { closeSync, fstatSync, openSync, readSync, type Stats, statSync } from 'node:fs';
import { inputError } from '../../formats/diagnostics/inputError.ts';
import { RangedFile } from '../../formats/files/rangedFile.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
import type { StoredFile } from '../../scene/streaming/storedNumbers.ts';

/** A file on disk with its state when it was opened; plain data that can be sent to threads. */
interface DiskFile {
  readonly path: string;
  readonly size: number;
  readonly modified: number;
}

/** Open file descriptors per thread; the least recently used is closed. */
const MAX_OPEN_FILES = 32;
const descriptors = new Map<string, number>();

/** A file whose byte ranges can be read; undefined if it does not exist. `name`: for messages. */
export function openDiskFile(path: string, name: string): RangedFile | undefined {
  const stats = statsOf(path);
  if (!stats?.isFile()) return undefined;
  const handle: DiskFile = { path, size: stats.size, modified: stats.mtimeMs };
  return new RangedFile({ name, handle }, stats.size);
}

/** Undefined also below what is a file itself. */
function statsOf(path: string): Stats | undefined {
  try {
    return statSync(path, { throwIfNoEntry: false });
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'ENOTDIR') return undefined;
    throw error;
  }
}

/** Reads bytes `at` to `at + length` of a file that `openDiskFile` opened, in any thread; for `setFileReader` of scene/streaming/storedNumbers.ts. Throws if the file has changed. */
export function readDiskFile({ name, handle }: StoredFile, at: number, length: number): Uint8Array<ArrayBuffer> {
  const file = handle as DiskFile;
  const bytes = new Uint8Array(length);
  try {
    const descriptor = descriptorOf(file.path);
    if (!isUnchanged(file, fstatSync(descriptor))) throw fileChanged(name, msg`it was written to since`);
    for (let done = 0; done < length; ) {
      const read = readSync(descriptor, bytes, done, length - done, at + done);
      if (read === 0) throw fileChanged(name, msg`it ends before byte ${at + length}`);
      done += read;
    }
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    throw code === undefined ? error : fileChanged(name, code);
  }
  return bytes;
}

const isUnchanged = ({ size, modified }: DiskFile, stats: Stats): boolean =>
  stats.size === size && stats.mtimeMs === modified;

const fileChanged = (name: string, why: LocalizedText): Error =>
  inputError('file.changed', name, msg`it is not what was opened any more (${why}); open the scene again`);

function descriptorOf(path: string): number {
  const descriptor = descriptors.get(path) ?? openSync(path, 'r');
  descriptors.delete(path);
  descriptors.set(path, descriptor);
  const [oldest, unused] = descriptors.entries().next().value!;
  if (descriptors.size > MAX_OPEN_FILES) {
    descriptors.delete(oldest);
    closeSync(unused);
  }
  return descriptor;
}
