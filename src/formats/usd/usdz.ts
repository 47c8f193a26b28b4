import { inputError } from '../fail.ts';
import { type Content, FileWindow } from '../rangedFile.ts';
import { normalizePath } from '../source.ts';

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const END_SIZE = 22;
const MAX_COMMENT = 65535;

export interface UsdzPackage {
  /** The layer that is the package's stage: its first file that is one. */
  readonly layer: string;
  readonly files: ReadonlyMap<string, Content>;
}

export const isZip = (bytes: Uint8Array): boolean =>
  bytes.length >= 4 && bytes[0] === 0x50 && bytes[1] === 0x4b && bytes[2] <= 8 && bytes[3] === bytes[2] + 1;

/** The files of a usdz: a zip whose files are stored as they are (usdz specification 1.3). Nothing is copied. */
export function openPackage(content: Content, name: string): UsdzPackage {
  const zip = new ZipReader(content, name);
  const files = zip.files();
  const layer = [...files.keys()].find((path) => /\.usd[ac]?$/i.test(path));
  if (layer === undefined)
    throw inputError(
      'usd.package',
      name,
      `the package holds no USD layer (${files.size} files: ${[...files.keys()].slice(0, 5).join(', ')})`,
    );
  return { layer, files };
}

class ZipReader extends FileWindow {
  private readonly name: string;

  constructor(content: Content, name: string) {
    super(content);
    this.name = name;
  }

  files(): Map<string, Content> {
    const end = this.findEnd();
    const count = this.u16(end + 10);
    let at = this.u32(end + 16);
    if (count === 0xffff || at === 0xffffffff)
      this.fail('is a zip64 package, which is not read; make it smaller than 4 GiB');
    const files = new Map<string, Content>();
    for (let i = 0; i < count; i++) {
      if (this.u32(at) !== CENTRAL) this.fail(`the directory of the package is damaged at byte ${at}`);
      const path = this.path(at + 46, this.u16(at + 28));
      if (!path.endsWith('/')) files.set(normalizePath(path), this.stored(at, path));
      at += 46 + this.u16(at + 28) + this.u16(at + 30) + this.u16(at + 32);
    }
    return files;
  }

  private findEnd(): number {
    const last = this.size - END_SIZE;
    for (let at = last; at >= 0 && at >= last - MAX_COMMENT; at--) if (this.u32(at) === END) return at;
    return this.fail('the package has no directory; it may be cut off');
  }

  /** A path inside the package; one that leads out of it is refused. */
  private path(at: number, length: number): string {
    this.need(at, length);
    const path = new TextDecoder().decode(this.slice(at, length));
    const parts = path.split(/[/\\]/);
    if (parts.includes('..') || /^([/\\]|[a-zA-Z]:)/.test(path) || path.includes('\0'))
      this.fail(`holds a file named '${path}', which leads out of the package`);
    return path;
  }

  private stored(entry: number, path: string): Content {
    if (this.u16(entry + 8) & 1) this.fail(`${path} in it is encrypted; save the package without a password`);
    const method = this.u16(entry + 10);
    const size = this.u32(entry + 24);
    if (method !== 0)
      this.fail(`${path} in it is compressed (method ${method}), which usdz does not allow; pack it with usdzip`);
    if (this.u32(entry + 20) !== size) this.fail(`${path} in it has two different sizes`);
    const local = this.u32(entry + 42);
    if (this.u32(local) !== LOCAL) this.fail(`${path} in it is not where the directory says (byte ${local})`);
    const start = local + 30 + this.u16(local + 26) + this.u16(local + 28);
    this.check(start, size);
    return this.part(start, size) ?? this.bytes.subarray(start, start + size);
  }

  private u16(at: number): number {
    this.need(at, 2);
    return this.view.getUint16(at - this.base, true);
  }

  private u32(at: number): number {
    this.need(at, 4);
    return this.view.getUint32(at - this.base, true);
  }

  private need(at: number, length: number): void {
    this.check(at, length);
    this.hold(at, length);
  }

  private check(at: number, length: number): void {
    if (at + length > this.size)
      this.fail(`the package ends at byte ${this.size}, before byte ${at + length}; it is cut off`);
  }

  private fail(message: string): never {
    throw inputError('usd.package', this.name, message);
  }
}
