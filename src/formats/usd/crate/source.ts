import { formatBytes, inputError } from '../../fail.ts';

/**
 * The bytes of a crate file, and where in it the reader is, for messages. A crate is little-endian, as every machine
 * with typed arrays of note is: arrays are copied as they lie.
 */
export class CrateSource {
  readonly file: string;
  readonly bytes: Uint8Array;
  readonly view: DataView;
  /** Of the file: 8 is 0.8. Set by the header. */
  version = 0;
  /** The section that is read, or the spec and which of its fields. */
  section = '';
  node: { readonly path: string } | undefined;
  field = '';
  private left: number;
  private readonly most: number;

  constructor(bytes: Uint8Array, file: string, budget: number) {
    // Not a Buffer of Node, whose slices are no copies.
    this.bytes = new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.file = file;
    this.left = budget;
    this.most = budget;
  }

  /** Checks that `length` bytes from `at` are in the file. */
  need(at: number, length: number, what: string): void {
    if (at < 0) this.fail(`${what} lies at byte ${at}, before the file`, at);
    if (at + length <= this.bytes.length) return;
    const wanted = `${what} takes ${length} bytes from byte ${at}`;
    this.fail(`${wanted}, and the file ends at byte ${this.bytes.length}; it is cut off or damaged`, at);
  }

  /** Accounts for memory before it is taken: what a few bytes stand for can be without bound. */
  spend(bytes: number, what: string, at?: number): void {
    if (bytes <= this.left) {
      this.left -= bytes;
      return;
    }
    const limit = `a crate file of ${formatBytes(this.bytes.length)} is read to ${formatBytes(this.most)}`;
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

/** Reads one thing after the other. */
export class Cursor {
  readonly source: CrateSource;
  at: number;

  constructor(source: CrateSource, at: number) {
    this.source = source;
    this.at = at;
  }

  /** Passes `length` bytes; where they begin. */
  pass(length: number, what: string): number {
    const { at } = this;
    this.source.need(at, length, what);
    this.at = at + length;
    return at;
  }

  u8(what: string): number {
    return this.source.view.getUint8(this.pass(1, what));
  }

  i32(what: string): number {
    return this.source.view.getInt32(this.pass(4, what), true);
  }

  u32(what: string): number {
    return this.source.view.getUint32(this.pass(4, what), true);
  }

  f64(what: string): number {
    return this.source.view.getFloat64(this.pass(8, what), true);
  }

  big(what: string): bigint {
    return this.source.view.getBigInt64(this.pass(8, what), true);
  }

  /** A signed 64-bit integer that a double holds, as every offset in a file does. */
  i64(what: string): number {
    const at = this.pass(8, what);
    const { view } = this.source;
    const value = view.getInt32(at + 4, true) * 2 ** 32 + view.getUint32(at, true);
    return Number.isSafeInteger(value) ? value : this.source.fail(`${what} is ${value}, which no file has`, at);
  }

  /** How many items follow, each of `itemBytes` at least. */
  count(what: string, itemBytes: number): number {
    const { at } = this;
    const count = this.i64(`the number of ${what}`);
    const room = this.source.bytes.length - this.at;
    if (count < 0 || count * itemBytes > room)
      this.source.fail(`it says ${count} ${what}, for which the ${room} bytes that are left cannot hold room`, at);
    return count;
  }
}
