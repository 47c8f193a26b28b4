import { formatBytes, inputError } from '../../../diagnostics/inputError.ts';
import { type FileContent, FileWindow } from '../../../files/rangedFile.ts';

/**
 * A crate file's bytes and the reader's position, for messages. Crates are little-endian, as all relevant platforms
 * are: arrays are copied as they are.
 */
export class CrateSource extends FileWindow {
  readonly file: string;
  /** Of the file: 8 is 0.8. Set by the header. */
  version = 0;
  /** The section being read, or the spec and field. */
  section = '';
  node: { readonly path: string } | undefined;
  field = '';
  private left: number;
  private readonly budget: number;

  constructor(content: FileContent, file: string, budget: number) {
    super(content);
    this.file = file;
    this.left = budget;
    this.budget = budget;
  }

  /** Checks that `length` bytes from `at` are in the file, and has them in the window. */
  require(at: number, length: number, what: string): void {
    this.check(at, length, what);
    this.ensure(at, length);
  }

  /** Checks that `length` bytes from `at` are in the file. */
  check(at: number, length: number, what: string): void {
    if (at < 0) this.fail(`${what} lies at byte ${at}, before the file`, at);
    if (at + length <= this.size) return;
    const wanted = `${what} takes ${length} bytes from byte ${at}`;
    this.fail(`${wanted}, and the file ends at byte ${this.size}; it is cut off or damaged`, at);
  }

  /** Accounts for memory before allocation: small data can expand without bound. */
  spend(bytes: number, what: string, at?: number): void {
    if (bytes <= this.left) {
      this.left -= bytes;
      return;
    }
    const limit = `a crate file of ${formatBytes(this.size)} is read to ${formatBytes(this.budget)}`;
    const message = `${what} would take ${formatBytes(bytes)} where ${formatBytes(this.left)} are left: ${limit}; split it into several layers`;
    throw inputError('file.too-large', this.where(at), message);
  }

  fail(message: string, at?: number): never {
    throw inputError('usd.crate', this.where(at), message);
  }

  private where(at: number | undefined): string {
    const inside = this.node ? `<${this.node.path}>${this.field && ` ${this.field}`}` : '';
    const details = [this.node ? '' : this.section, at === undefined ? '' : `byte ${at}`].filter(Boolean);
    return `${this.file}${inside}${details.length > 0 ? ` (${details.join(', ')})` : ''}`;
  }
}

/** A sequential reader. */
export class Cursor {
  readonly source: CrateSource;
  at: number;

  constructor(source: CrateSource, at: number) {
    this.source = source;
    this.at = at;
  }

  /** Skips `length` bytes; returns their offset. */
  pass(length: number, what: string): number {
    const { at } = this;
    this.source.require(at, length, what);
    this.at = at + length;
    return at;
  }

  /** Skips bytes that are read elsewhere; returns their offset. */
  skip(length: number, what: string): number {
    const { at } = this;
    this.source.check(at, length, what);
    this.at = at + length;
    return at;
  }

  /** Skips `length` bytes; returns their offset in the window. */
  private inWindow(length: number, what: string): number {
    return this.pass(length, what) - this.source.base;
  }

  u8(what: string): number {
    const at = this.inWindow(1, what);
    return this.source.view.getUint8(at);
  }

  i32(what: string): number {
    const at = this.inWindow(4, what);
    return this.source.view.getInt32(at, true);
  }

  u32(what: string): number {
    const at = this.inWindow(4, what);
    return this.source.view.getUint32(at, true);
  }

  f64(what: string): number {
    const at = this.inWindow(8, what);
    return this.source.view.getFloat64(at, true);
  }

  big(what: string): bigint {
    const at = this.inWindow(8, what);
    return this.source.view.getBigInt64(at, true);
  }

  /** A signed 64-bit integer that a double holds, as every offset in a file does. */
  i64(what: string): number {
    const at = this.inWindow(8, what);
    const { view, base } = this.source;
    const value = view.getInt32(at + 4, true) * 2 ** 32 + view.getUint32(at, true);
    return Number.isSafeInteger(value) ? value : this.source.fail(`${what} is ${value}, which no file has`, base + at);
  }

  /** Reads an item count, checked against the remaining bytes at `itemBytes` or more per item. */
  count(what: string, itemBytes: number): number {
    const { at } = this;
    const count = this.i64(`the number of ${what}`);
    const room = this.source.size - this.at;
    if (count < 0 || count * itemBytes > room)
      this.source.fail(`it says ${count} ${what}, for which the ${room} bytes that are left cannot hold room`, at);
    return count;
  }
}
