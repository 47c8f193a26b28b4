import { readRange, type StoredFile } from '../../scene/streaming/storedNumbers.ts';

/** A file, or a part of one, that is not in memory: parts of it are read when they are needed. */
export class RangedFile {
  readonly file: StoredFile;
  /** Where in the file it begins [byte]. */
  readonly start: number;
  /** [bytes] */
  readonly size: number;

  constructor(file: StoredFile, size: number, start = 0) {
    this.file = file;
    this.start = start;
    this.size = size;
  }

  /** A copy of `length` bytes from `at` on; both lie within it. */
  read(at: number, length: number): Uint8Array<ArrayBuffer> {
    return readRange(this.file, this.start + at, length);
  }

  part(at: number, size: number): RangedFile {
    return new RangedFile(this.file, size, this.start + at);
  }
}

/** What a file holds: in memory, or to be read in parts. */
export type FileContent = Uint8Array | RangedFile;

export const contentSize = (content: FileContent): number =>
  content instanceof RangedFile ? content.size : content.length;

/** All of it, in memory. */
export const contentBytes = (content: FileContent): Uint8Array =>
  content instanceof RangedFile ? content.read(0, content.size) : content;

/** Its first bytes, `length` of them where there are so many. */
export const contentHead = (content: FileContent, length: number): Uint8Array =>
  content instanceof RangedFile ? content.read(0, Math.min(length, content.size)) : content.subarray(0, length);

/** Small things are read by pages of so many bytes, of which so many are kept. */
const [PAGE, MOST_PAGES] = [2 ** 16, 64];

/**
 * Looks at a file through a window: `hold` moves it to where bytes are wanted. What is in memory is one window that never
 * moves, from byte 0 on.
 */
export class FileWindow {
  readonly size: number;
  /** What is in the window. */
  bytes: Uint8Array;
  view: DataView;
  /** Byte of the file at which it begins. */
  base = 0;
  private readonly ranged: RangedFile | undefined;
  private readonly pages = new Map<number, Uint8Array>();

  constructor(content: FileContent) {
    this.size = contentSize(content);
    this.ranged = content instanceof RangedFile ? content : undefined;
    // Not a Buffer of Node, whose slices are no copies.
    this.bytes =
      content instanceof RangedFile
        ? new Uint8Array(0)
        : new Uint8Array(content.buffer, content.byteOffset, content.byteLength);
    this.view = viewOf(this.bytes);
  }

  /** Makes [at, at + length), which are bytes of the file, be in the window. */
  ensure(at: number, length: number): void {
    if (!this.ranged || (at >= this.base && at + length <= this.base + this.bytes.length)) return;
    const page = Math.floor(at / PAGE);
    const fits = at + length <= (page + 1) * PAGE;
    this.base = fits ? page * PAGE : at;
    this.bytes = fits ? this.page(this.ranged, page) : this.ranged.read(at, length);
    this.view = viewOf(this.bytes);
  }

  /** A copy of bytes of the file, of which a large one leaves the window where it is. */
  slice(at: number, length: number): Uint8Array<ArrayBuffer> {
    if (this.ranged && length > PAGE) return this.ranged.read(at, length);
    this.ensure(at, length);
    return this.bytes.slice(at - this.base, at - this.base + length) as Uint8Array<ArrayBuffer>;
  }

  /** `length` bytes from `at` on, to be read later; undefined of what is in memory. */
  part(at: number, length: number): RangedFile | undefined {
    return this.ranged?.part(at, length);
  }

  private page(file: RangedFile, page: number): Uint8Array {
    const found = this.pages.get(page) ?? file.read(page * PAGE, Math.min(PAGE, file.size - page * PAGE));
    this.pages.delete(page);
    this.pages.set(page, found);
    if (this.pages.size > MOST_PAGES) this.pages.delete(this.pages.keys().next().value!);
    return found;
  }
}

const viewOf = ({ buffer, byteOffset, byteLength }: Uint8Array): DataView =>
  new DataView(buffer, byteOffset, byteLength);
