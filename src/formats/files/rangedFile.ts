import { readRange, type StoredFile } from '../../scene/streaming/storedNumbers.ts';

/** A file or a part of one on disk, read on demand. */
export class RangedFile {
  readonly file: StoredFile;
  /** Offset in the file [bytes]. */
  readonly start: number;
  /** [bytes] */
  readonly size: number;

  constructor(file: StoredFile, size: number, start = 0) {
    this.file = file;
    this.start = start;
    this.size = size;
  }

  /** A copy of `length` bytes at `at`; the range must lie within it. */
  read(at: number, length: number): Uint8Array<ArrayBuffer> {
    return readRange(this.file, this.start + at, length);
  }

  part(at: number, size: number): RangedFile {
    return new RangedFile(this.file, size, this.start + at);
  }
}

/** File contents: in memory, or read on demand. */
export type FileContent = Uint8Array | RangedFile;

export const contentSize = (content: FileContent): number =>
  content instanceof RangedFile ? content.size : content.length;

/** The whole contents in memory. */
export const contentBytes = (content: FileContent): Uint8Array =>
  content instanceof RangedFile ? content.read(0, content.size) : content;

/** The first `length` bytes, or fewer if shorter. */
export const contentHead = (content: FileContent, length: number): Uint8Array =>
  content instanceof RangedFile ? content.read(0, Math.min(length, content.size)) : content.subarray(0, length);

/** Size [bytes] and maximum number of cached pages for small reads. */
const [PAGE, MAX_PAGES] = [2 ** 16, 64];

/** A sliding window over a file: `ensure` moves it to the wanted bytes. In-memory contents are one fixed window from byte 0. */
export class FileWindow {
  readonly size: number;
  /** Bytes in the window. */
  bytes: Uint8Array;
  view: DataView;
  /** Offset of the window in the file. */
  base = 0;
  private readonly ranged: RangedFile | undefined;
  private readonly pages = new Map<number, Uint8Array>();

  constructor(content: FileContent) {
    this.size = contentSize(content);
    this.ranged = content instanceof RangedFile ? content : undefined;
    // Not a Node Buffer, whose slice() does not copy.
    this.bytes =
      content instanceof RangedFile
        ? new Uint8Array(0)
        : new Uint8Array(content.buffer, content.byteOffset, content.byteLength);
    this.view = viewOf(this.bytes);
  }

  /** Moves the window so that it contains [at, at + length) of the file. */
  ensure(at: number, length: number): void {
    if (!this.ranged || (at >= this.base && at + length <= this.base + this.bytes.length)) return;
    const page = Math.floor(at / PAGE);
    const fits = at + length <= (page + 1) * PAGE;
    this.base = fits ? page * PAGE : at;
    this.bytes = fits ? this.page(this.ranged, page) : this.ranged.read(at, length);
    this.view = viewOf(this.bytes);
  }

  /** A copy of bytes of the file; a large one does not move the window. */
  slice(at: number, length: number): Uint8Array<ArrayBuffer> {
    if (this.ranged && length > PAGE) return this.ranged.read(at, length);
    this.ensure(at, length);
    return this.bytes.slice(at - this.base, at - this.base + length) as Uint8Array<ArrayBuffer>;
  }

  /** `length` bytes at `at` to be read later; undefined for in-memory contents. */
  part(at: number, length: number): RangedFile | undefined {
    return this.ranged?.part(at, length);
  }

  private page(file: RangedFile, page: number): Uint8Array {
    const found = this.pages.get(page) ?? file.read(page * PAGE, Math.min(PAGE, file.size - page * PAGE));
    this.pages.delete(page);
    this.pages.set(page, found);
    if (this.pages.size > MAX_PAGES) this.pages.delete(this.pages.keys().next().value!);
    return found;
  }
}

const viewOf = ({ buffer, byteOffset, byteLength }: Uint8Array): DataView =>
  new DataView(buffer, byteOffset, byteLength);
