import { type LocalizedText, listed, type Message, msg } from '../../../../messages/message.ts';
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
  section: LocalizedText = '';
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
  require(at: number, length: number, what: LocalizedText): void {
    this.check(at, length, what);
    this.ensure(at, length);
  }

  /** Checks that `length` bytes from `at` are in the file. */
  check(at: number, length: number, what: LocalizedText): void {
    if (at < 0) this.fail(msg`${what} lies at byte ${at}, before the file`, at);
    if (at + length <= this.size) return;
    const wanted = msg`${what} takes ${length} bytes from byte ${at}`;
    this.fail(msg`${wanted}, and the file ends at byte ${this.size}; it is cut off or damaged`, at);
  }

  /** Accounts for memory before allocation: small data can expand without bound. */
  spend(bytes: number, what: LocalizedText, at?: number): void {
    if (bytes <= this.left) {
      this.left -= bytes;
      return;
    }
    const limit = msg`a crate file of ${formatBytes(this.size)} is read to ${formatBytes(this.budget)}`;
    const message = msg`${what} would take ${formatBytes(bytes)} where ${formatBytes(this.left)} are left: ${limit}; split it into several layers`;
    throw inputError('file.too-large', this.where(at), message);
  }

  fail(message: Message, at?: number): never {
    throw inputError('usd.crate', this.where(at), message);
  }

  private where(at: number | undefined): LocalizedText {
    const { file, node, field, section } = this;
    const place = node ? `${file}<${node.path}>${field && ` ${field}`}` : file;
    const details = [node ? '' : section, at === undefined ? '' : msg`byte ${at}`].filter((detail) => detail !== '');
    return details.length > 0 ? msg`${place} (${listed(details)})` : place;
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
  pass(length: number, what: LocalizedText): number {
    const { at } = this;
    this.source.require(at, length, what);
    this.at = at + length;
    return at;
  }

  /** Skips bytes that are read elsewhere; returns their offset. */
  skip(length: number, what: LocalizedText): number {
    const { at } = this;
    this.source.check(at, length, what);
    this.at = at + length;
    return at;
  }

  /** Skips `length` bytes; returns their offset in the window. */
  private inWindow(length: number, what: LocalizedText): number {
    return this.pass(length, what) - this.source.base;
  }

  u8(what: LocalizedText): number {
    const at = this.inWindow(1, what);
    return this.source.view.getUint8(at);
  }

  i32(what: LocalizedText): number {
    const at = this.inWindow(4, what);
    return this.source.view.getInt32(at, true);
  }

  u32(what: LocalizedText): number {
    const at = this.inWindow(4, what);
    return this.source.view.getUint32(at, true);
  }

  f64(what: LocalizedText): number {
    const at = this.inWindow(8, what);
    return this.source.view.getFloat64(at, true);
  }

  big(what: LocalizedText): bigint {
    const at = this.inWindow(8, what);
    return this.source.view.getBigInt64(at, true);
  }

  /** A signed 64-bit integer that a double holds, as every offset in a file does. */
  i64(what: LocalizedText): number {
    const at = this.inWindow(8, what);
    const { view, base } = this.source;
    const value = view.getInt32(at + 4, true) * 2 ** 32 + view.getUint32(at, true);
    return Number.isSafeInteger(value)
      ? value
      : this.source.fail(msg`${what} is ${value}, which no file has`, base + at);
  }

  /** Reads an item count, checked against the remaining bytes at `itemBytes` or more per item. */
  count(what: LocalizedText, itemBytes: number): number {
    const { at } = this;
    const count = this.i64(msg`the number of ${what}`);
    const room = this.source.size - this.at;
    if (count < 0 || count * itemBytes > room)
      this.source.fail(msg`it says ${count} ${what}, for which the ${room} bytes that are left cannot hold room`, at);
    return count;
  }
}
