import { closeSync, fstatSync, openSync, readSync, type Stats, statSync } from 'node:fs';
import { inputError } from '../formats/fail.ts';
import { RangedFile } from '../formats/rangedFile.ts';
import type { StoredFile } from '../scene/storedNumbers.ts';

/** A file on disk as it was when it was opened; plain data, for threads. */
interface DiskFile {
  readonly path: string;
  readonly size: number;
  readonly modified: number;
}

/** So many files are kept open in a thread. */
const MOST_OPEN = 32;
const opened = new Map<string, number>();

/** A file of which parts can be read; undefined where there is none. `name`: for messages. */
export function openDiskFile(path: string, name: string): RangedFile | undefined {
  const stats = statSync(path, { throwIfNoEntry: false });
  if (!stats?.isFile()) return undefined;
  const handle: DiskFile = { path, size: stats.size, modified: stats.mtimeMs };
  return new RangedFile({ name, handle }, stats.size);
}

/** Reads a part of a file that `openDiskFile` opened, in any thread: `readFilesWith` of scene/storedNumbers.ts takes it. */
export function readDiskFile({ name, handle }: StoredFile, at: number, length: number): Uint8Array<ArrayBuffer> {
  const file = handle as DiskFile;
  const bytes = new Uint8Array(length);
  try {
    const descriptor = descriptorOf(file.path);
    if (!isAsOpened(file, fstatSync(descriptor))) throw changed(name, 'it was written to since');
    for (let done = 0; done < length; ) {
      const read = readSync(descriptor, bytes, done, length - done, at + done);
      if (read === 0) throw changed(name, `it ends before byte ${at + length}`);
      done += read;
    }
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    throw code === undefined ? error : changed(name, code);
  }
  return bytes;
}

const isAsOpened = ({ size, modified }: DiskFile, stats: Stats): boolean =>
  stats.size === size && stats.mtimeMs === modified;

const changed = (name: string, why: string): Error =>
  inputError('file.changed', name, `it is not what was opened any more (${why}); open the scene again`);

function descriptorOf(path: string): number {
  const descriptor = opened.get(path) ?? openSync(path, 'r');
  opened.delete(path);
  opened.set(path, descriptor);
  const [oldest, unused] = opened.entries().next().value!;
  if (opened.size > MOST_OPEN) {
    opened.delete(oldest);
    closeSync(unused);
  }
  return descriptor;
}
