import { crc32 } from '../../files/crc32.ts';

/** Files in a usdz begin at multiples of this [bytes] (usdz specification), so that they can be mapped into memory. */
const ALIGNMENT = 64;
/** 1 January 1980, the earliest date a zip can hold: the same scene gives the same bytes. */
const DOS_DATE = 0x21;
/** "Unicode names" of the zip specification. */
const UTF8_FLAG = 0x800;
const PADDING_ID = 0x1986;

interface ZipFileEntry {
  readonly name: Uint8Array;
  readonly data: Uint8Array;
  readonly crc: number;
  readonly offset: number;
  readonly extra: number;
}

/** A zip of uncompressed files in the order given; the first must be the layer. */
export function packUsdz(files: ReadonlyMap<string, Uint8Array>): Uint8Array {
  const entries: ZipFileEntry[] = [];
  let offset = 0;
  for (const [path, data] of files) {
    const name = new TextEncoder().encode(path);
    const extra = paddingFor(offset + 30 + name.length);
    entries.push({ name, data, crc: crc32(data), offset, extra });
    offset += 30 + name.length + extra + data.length;
  }
  const directory = entries.reduce((n, e) => n + 46 + e.name.length, 0);
  const bytes = new Uint8Array(offset + directory + 22);
  const view = new DataView(bytes.buffer);
  for (const entry of entries) writeLocal(bytes, view, entry);
  let at = offset;
  for (const entry of entries) at = writeCentralDirectoryEntry(bytes, view, entry, at);
  writeEnd(view, at, entries.length, directory, offset);
  return bytes;
}

/** Length of an extra field (its own header is 4) that puts what follows `position` on the alignment. */
function paddingFor(position: number): number {
  const gap = (ALIGNMENT - (position % ALIGNMENT)) % ALIGNMENT;
  return gap === 0 ? 0 : gap < 4 ? gap + ALIGNMENT : gap;
}

/** The fields that both headers share, from `version needed` on. */
function writeCommon(view: DataView, at: number, { data, crc, name }: ZipFileEntry): void {
  view.setUint16(at, 20, true);
  view.setUint16(at + 2, UTF8_FLAG, true);
  view.setUint16(at + 8, DOS_DATE, true);
  view.setUint32(at + 10, crc, true);
  view.setUint32(at + 14, data.length, true);
  view.setUint32(at + 18, data.length, true);
  view.setUint16(at + 22, name.length, true);
}

function writeLocal(bytes: Uint8Array, view: DataView, entry: ZipFileEntry): void {
  const { offset, name, extra, data } = entry;
  view.setUint32(offset, 0x04034b50, true);
  writeCommon(view, offset + 4, entry);
  view.setUint16(offset + 28, extra, true);
  bytes.set(name, offset + 30);
  const padding = offset + 30 + name.length;
  if (extra > 0) {
    view.setUint16(padding, PADDING_ID, true);
    view.setUint16(padding + 2, extra - 4, true);
  }
  bytes.set(data, padding + extra);
}

function writeCentralDirectoryEntry(bytes: Uint8Array, view: DataView, entry: ZipFileEntry, at: number): number {
  view.setUint32(at, 0x02014b50, true);
  view.setUint16(at + 4, 20, true);
  writeCommon(view, at + 6, entry);
  view.setUint32(at + 42, entry.offset, true);
  bytes.set(entry.name, at + 46);
  return at + 46 + entry.name.length;
}

function writeEnd(view: DataView, at: number, count: number, size: number, offset: number): void {
  view.setUint32(at, 0x06054b50, true);
  view.setUint16(at + 8, count, true);
  view.setUint16(at + 10, count, true);
  view.setUint32(at + 12, size, true);
  view.setUint32(at + 16, offset, true);
}
