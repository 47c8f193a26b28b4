import { listed, type Message, msg } from '../../../messages/message.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import { type FileContent, FileWindow } from '../../files/rangedFile.ts';
import { dataStart, directoryPlace, entriesIn, LOCAL_SIZE, TAIL, type ZipEntry } from '../../zip/directory.ts';

export interface UsdzPackage {
  /** The root layer of the package: its first layer, or a package with that. */
  readonly layer: string;
  readonly files: ReadonlyMap<string, FileContent>;
}

export const isZip = (bytes: Uint8Array): boolean =>
  bytes.length >= 4 && bytes[0] === 0x50 && bytes[1] === 0x4b && bytes[2] <= 8 && bytes[3] === bytes[2] + 1;

/** The files of a usdz: a zip whose files are stored as they are (usdz specification 1.3). Nothing is copied. */
export function openPackage(content: FileContent, name: string): UsdzPackage {
  const window = new FileWindow(content);
  const from = Math.max(0, window.size - TAIL);
  const { count, start, size } = directoryPlace(window.slice(from, window.size - from), from, name);
  const entries = entriesIn(window.slice(start, size), count, window.size, name);
  const files = new Map(entries.map((entry) => [entry.path, stored(window, entry, name)]));
  const layer = [...files.keys()].find((path) => /\.usd[acz]?$/i.test(path));
  if (layer !== undefined) return { layer, files };
  const held = msg`${files.size} files: ${listed([...files.keys()].slice(0, 5))}`;
  throw inputError('usd.package', name, msg`the package holds no USD layer (${held})`);
}

/** A file of a package, where it is. */
function stored(window: FileWindow, entry: ZipEntry, name: string): FileContent {
  const { path, method, packed, size, offset } = entry;
  const fail = (message: Message): never => {
    throw inputError('usd.package', name, message);
  };
  if (method !== 0)
    fail(msg`${path} in it is compressed (method ${method}), which usdz does not allow; pack it with usdzip`);
  if (packed !== size) fail(msg`${path} in it has two different sizes`);
  const start = dataStart(window.slice(offset, LOCAL_SIZE), entry, name);
  if (start + size > window.size)
    fail(msg`${path} in it ends at byte ${start + size} of ${window.size}; it is cut off`);
  return window.part(start, size) ?? window.bytes.subarray(start, start + size);
}
