import { type Message, msg } from '../../messages/message.ts';
import { formatBytes, inputError } from '../diagnostics/inputError.ts';
import { normalizePath } from '../files/fileSource.ts';

/** A random access file: on disk, in a browser, in memory. */
export interface RandomAccessFile {
  /** [bytes] */
  readonly size: number;
  /** The bytes from `from` up to `to`; both lie in the file. */
  read(from: number, to: number): Promise<Uint8Array>;
}

/** Directory entry of a file in an archive; plain data. */
export interface ZipEntry {
  readonly path: string;
  /** 0: stored, 8: deflated. */
  readonly method: number;
  /** Sizes in the archive and unpacked [bytes]. */
  readonly packed: number;
  readonly size: number;
  readonly crc: number;
  /** Of its local header [bytes]. */
  readonly offset: number;
}

const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const ZIP64_LOCATOR = 0x07064b50;
const END_SIZE = 22;
const LOCATOR_SIZE = 20;
const LOCAL = 0x04034b50;
/** Size of a local header [bytes]. */
export const LOCAL_SIZE = 30;
const MAX_COMMENT = 65535;
/** Maximum total unpacked size of an archive [bytes]. */
export const MAX_TOTAL = 2 ** 31;
/** Maximum compression ratio of deflate. */
export const MAX_RATIO = 1032;
/** Archives above this unpacked size [bytes] and ratio are rejected as bombs. */
const BOMB_TOTAL = 2 ** 28;
const BOMB_RATIO = 200;

/**
 * The files of a zip archive, of which only the directory is read. Throws an InputError where it is damaged, encrypted or too
 * large, where a name leads out of it or is there twice, and where files share their bytes, as bombs do.
 */
export async function readZipDirectory(file: RandomAccessFile, name: string): Promise<ZipEntry[]> {
  const from = Math.max(0, file.size - TAIL);
  const { count, start, size } = directoryPlace(await file.read(from, file.size), from, name);
  return entriesIn(await file.read(start, start + size), count, file.size, name);
}

/** Metadata files that macOS adds. */
const isClutter = (path: string): boolean => /(^|\/)(__MACOSX|\.DS_Store|\._[^/]*)(\/|$)/.test(path);

const fail = (name: string, message: Message): never => {
  throw inputError('zip.damaged', name, message);
};

/** Location of an archive's central directory. */
export interface DirectoryPlace {
  readonly count: number;
  /** [bytes] */
  readonly start: number;
  readonly size: number;
}

/** Size of the tail that locates the directory [bytes]. */
export const TAIL = END_SIZE + MAX_COMMENT + LOCATOR_SIZE;

/** Locates the directory from an archive's tail, which begins at byte `from`. */
export function directoryPlace(tail: Uint8Array, from: number, name: string): DirectoryPlace {
  const view = new DataView(tail.buffer, tail.byteOffset, tail.byteLength);
  let at = tail.length - END_SIZE;
  while (at >= 0 && view.getUint32(at, true) !== END) at--;
  if (at < 0) return fail(name, msg`the archive has no directory; it is cut off or no zip, copy it again`);
  const [count, size, start] = [
    view.getUint16(at + 10, true),
    view.getUint32(at + 12, true),
    view.getUint32(at + 16, true),
  ];
  const hasLocator = at >= LOCATOR_SIZE && view.getUint32(at - LOCATOR_SIZE, true) === ZIP64_LOCATOR;
  if (hasLocator || count === 0xffff || start === 0xffffffff)
    throw inputError(
      'zip.zip64',
      name,
      msg`is a zip64 archive, which is not read; pack less than 4 GiB and 65 535 files, or open the folder itself`,
    );
  if (view.getUint16(at + 4, true) !== 0 || view.getUint16(at + 8, true) !== count)
    throw inputError('zip.parts', name, msg`is one part of a split archive, which is not read; pack it as one file`);
  if (start + size > from + at)
    return fail(name, msg`its directory (${size} bytes at ${start}) goes beyond its end; it is cut off, copy it again`);
  return { count, start, size };
}

/** The files that a directory lists, in an archive of `fileSize` bytes. */
export function entriesIn(directory: Uint8Array, count: number, fileSize: number, name: string): ZipEntry[] {
  const entries = new Directory(directory, name).entries(count);
  checkNames(entries, name);
  checkSizes(entries, fileSize, name);
  return entries.filter(({ path }) => !isClutter(path));
}

/** Offset of a file's data, by its local header. */
export function dataStart(header: Uint8Array, { path, offset }: ZipEntry, name: string): number {
  const view = new DataView(header.buffer, header.byteOffset, header.byteLength);
  if (header.length < LOCAL_SIZE || view.getUint32(0, true) !== LOCAL)
    fail(name, msg`${path} in it is not where the directory says (byte ${offset}); copy or pack it again`);
  return offset + LOCAL_SIZE + view.getUint16(26, true) + view.getUint16(28, true);
}

class Directory {
  private readonly view: DataView;
  private readonly bytes: Uint8Array;
  private readonly name: string;

  constructor(bytes: Uint8Array, name: string) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.name = name;
  }

  entries(count: number): ZipEntry[] {
    const found: ZipEntry[] = [];
    let at = 0;
    for (let i = 0; i < count; i++) {
      if (this.u32(at) !== CENTRAL) fail(this.name, msg`entry ${i} of its directory is damaged; copy it again`);
      const [nameLength, extra, comment] = [28, 30, 32].map((k) => this.u16(at + k));
      const path = this.path(at + 46, nameLength, (this.u16(at + 8) & 0x800) !== 0);
      if (!path.endsWith('/')) found.push(this.entry(at, path));
      at += 46 + nameLength + extra + comment;
    }
    return found;
  }

  private entry(at: number, path: string): ZipEntry {
    if (this.u16(at + 8) & 1)
      throw inputError('zip.encrypted', this.name, msg`${path} in it is encrypted; pack it without a password`);
    return {
      path: normalizePath(path),
      method: this.u16(at + 10),
      crc: this.u32(at + 16),
      packed: this.u32(at + 20),
      size: this.u32(at + 24),
      offset: this.u32(at + 42),
    };
  }

  /** File names are UTF-8, flagged or not; else Latin-1 as an approximation. */
  private path(at: number, length: number, isUtf8: boolean): string {
    if (at + length > this.bytes.length) fail(this.name, msg`its directory is cut off; copy it again`);
    const bytes = this.bytes.subarray(at, at + length);
    try {
      return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    } catch {
      if (isUtf8) fail(this.name, msg`the name of a file at byte ${at} of its directory is no UTF-8; pack it again`);
      return new TextDecoder('latin1').decode(bytes);
    }
  }

  private u16(at: number): number {
    if (at + 2 > this.bytes.length) fail(this.name, msg`its directory is cut off; copy it again`);
    return this.view.getUint16(at, true);
  }

  private u32(at: number): number {
    if (at + 4 > this.bytes.length) fail(this.name, msg`its directory is cut off; copy it again`);
    return this.view.getUint32(at, true);
  }
}

function checkNames(entries: readonly ZipEntry[], name: string): void {
  const seen = new Set<string>();
  for (const { path } of entries) {
    if (path.split('/').includes('..') || /^(\/|[a-zA-Z]:)/.test(path) || path.includes('\0'))
      throw inputError('zip.path', name, msg`holds a file named '${path}', which leads out of it; pack it again`);
    if (seen.has(path)) throw inputError('zip.duplicate', name, msg`holds two files named ${path}; pack it again`);
    seen.add(path);
  }
}

function checkSizes(entries: readonly ZipEntry[], fileSize: number, name: string): void {
  let total = 0;
  let free = 0;
  for (const { path, packed, size, offset } of [...entries].sort((a, b) => a.offset - b.offset)) {
    if (offset < free)
      throw inputError('zip.bomb', name, msg`${path} in it shares its bytes with another file; pack it again`);
    free = offset + LOCAL_SIZE + packed;
    if (free > fileSize)
      fail(name, msg`${path} in it ends at byte ${free} of ${fileSize}; it is cut off, copy it again`);
    if (size > packed * MAX_RATIO + MAX_RATIO)
      throw inputError(
        'zip.bomb',
        name,
        msg`${path} in it claims ${formatBytes(size)} of ${packed} bytes, which cannot be; pack it again`,
      );
    total += size;
  }
  if (total > MAX_TOTAL) {
    const message = msg`unpacked it takes ${formatBytes(total)}, more than the ${formatBytes(MAX_TOTAL)} that are read; leave out what the scene does not use`;
    throw inputError('zip.too-large', name, message);
  }
  if (total > BOMB_TOTAL && total > fileSize * BOMB_RATIO)
    throw inputError(
      'zip.bomb',
      name,
      msg`its ${formatBytes(fileSize)} unpack to ${formatBytes(total)}; that is no scene`,
    );
}
