import { unzlibSync } from 'fflate';
import { fromHalf } from '../../math/half.ts';
import { type Message, msg } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import { InputError } from '../../scene/types.ts';
import { inputError } from '../diagnostics/inputError.ts';
import {
  EXR_ENVMAPS,
  EXR_MAGIC,
  EXR_PIXEL_TYPES,
  EXR_ZIP,
  EXR_ZIP_ROWS,
  type ExrChannel,
  type ExrEnvmap,
  type ExrImage,
  exrValueBytes,
} from './exr.ts';

const COMPRESSIONS = ['none', 'RLE', 'ZIPS', 'ZIP', 'PIZ', 'PXR24', 'B44', 'B44A', 'DWAA', 'DWAB'];
const NONE = 0;
const ZIPS = 2;
/** Deflate makes nothing longer than this many times. */
const MAX_INFLATION = 1032;
/** Bits of the version word: tiles, deep data, several parts. */
const UNSUPPORTED_FLAGS: readonly (readonly [number, Message])[] = [
  [0x200, msg`tiled EXR`],
  [0x800, msg`deep EXR`],
  [0x1000, msg`multi-part EXR`],
];

/** Of one picture: all are held at once. */
const MAX_EXR_CHANNELS = 64;

interface ExrHeader {
  readonly width: number;
  readonly height: number;
  /** First row of the data window. */
  readonly top: number;
  readonly compression: number;
  readonly channels: readonly { readonly name: string; readonly type: ExrChannel['type'] }[];
  readonly attributes: Readonly<Record<string, string>>;
  readonly envmap?: ExrEnvmap;
}

/** Refuses, by throwing, a picture of a size. */
export type SizeCheck = (width: number, height: number, name: string) => void;

/**
 * Reads what `writeExr` writes, and the like of other programs; throws an InputError that names `name` where it cannot.
 * @example
 * const y = { name: 'Y', type: 'half', data: new Float32Array([0.25]) } as const;
 * readExr(writeExr({ width: 1, height: 1, channels: [y] }), 'one.exr').channels[0]; // { name: 'Y', type: 'half', data: [0.25] }
 */
export function readExr(bytes: Uint8Array, name: string, checkSize: SizeCheck = () => undefined): ExrImage {
  return unlessDamaged(name, () => {
    const cursor = new ByteCursor(bytes);
    const header = readHeader(cursor, name);
    checkSize(header.width, header.height, name);
    return { ...header, channels: readPixels(cursor, header) };
  });
}

/** What the header says, without the pixels; throws as `readExr` does. */
export const readExrHeader = (bytes: Uint8Array, name: string): Omit<ExrImage, 'channels'> =>
  unlessDamaged(name, () => readHeader(new ByteCursor(bytes), name));

function unlessDamaged<Result>(name: string, read: () => Result): Result {
  try {
    return read();
  } catch (thrown) {
    if (thrown instanceof InputError) throw thrown;
    const message = msg`the EXR is damaged or cut off (${messageOf(thrown)}); render or export it again`;
    throw inputError('image.damaged', name, message, thrown);
  }
}

function readHeader(cursor: ByteCursor, name: string): ExrHeader {
  if (cursor.int() !== EXR_MAGIC) throw inputError('image.unknown-format', name, msg`not an OpenEXR picture`);
  const version = cursor.int();
  const flag = UNSUPPORTED_FLAGS.find(([bit]) => version & bit);
  if (flag) throw unsupported(name, flag[1]);
  const found = new Map<string, ByteCursor>();
  const attributes: Record<string, string> = {};
  for (let key = cursor.text(); key !== ''; key = cursor.text()) {
    const type = cursor.text();
    const value = cursor.slice(cursor.int());
    if (type === 'string') attributes[key] = new TextDecoder().decode(value.rest());
    else found.set(key, value);
  }
  const need = (key: string): ByteCursor => {
    const value = found.get(key);
    if (!value) throw new MessageError(msg`no ${key} in the header`);
    return value;
  };
  const compression = need('compression').byte();
  if (![NONE, ZIPS, EXR_ZIP].includes(compression))
    throw unsupported(name, msg`${COMPRESSIONS[compression] ?? compression} compression`);
  const envmap = EXR_ENVMAPS[found.get('envmap')?.byte() ?? -1];
  return {
    ...readWindow(need('dataWindow')),
    compression,
    channels: readChannels(need('channels'), name),
    attributes,
    ...(envmap && { envmap }),
  };
}

const unsupported = (name: string, what: Message): InputError =>
  inputError('image.unsupported', name, msg`${what} is not read; save it as scan lines with ZIP or no compression`);

function readWindow(cursor: ByteCursor): Pick<ExrHeader, 'width' | 'height' | 'top'> {
  const [left, top, right, bottom] = [cursor.int(), cursor.int(), cursor.int(), cursor.int()];
  const [width, height] = [right - left + 1, bottom - top + 1];
  if (!(width > 0 && height > 0)) throw new MessageError(msg`data window of ${width} × ${height} pixels`);
  return { width, height, top };
}

function readChannels(cursor: ByteCursor, name: string): ExrHeader['channels'] {
  const channels: ExrHeader['channels'][number][] = [];
  for (let channel = cursor.text(); channel !== ''; channel = cursor.text()) {
    const type = EXR_PIXEL_TYPES[cursor.int()];
    cursor.int();
    const [xSampling, ySampling] = [cursor.int(), cursor.int()];
    if (!type) throw new MessageError(msg`channel ${channel} has no known type`);
    if (xSampling !== 1 || ySampling !== 1) throw unsupported(name, msg`subsampled channel ${channel}`);
    channels.push({ name: channel, type });
    if (channels.length > MAX_EXR_CHANNELS)
      throw unsupported(name, msg`an EXR of more than ${MAX_EXR_CHANNELS} channels`);
  }
  return channels;
}

function readPixels(cursor: ByteCursor, header: ExrHeader): ExrChannel[] {
  const { width, height, channels, compression, top } = header;
  const rowBytes = channels.reduce((sum, c) => sum + width * exrValueBytes(c.type), 0);
  if (rowBytes * height > cursor.left * MAX_INFLATION)
    throw new MessageError(msg`too short for ${width} × ${height} pixels`);
  const out = channels.map(
    ({ name, type }): ExrChannel => ({
      name,
      type,
      data: type === 'uint' ? new Uint32Array(width * height) : new Float32Array(width * height),
    }),
  );
  const blockRows = compression === EXR_ZIP ? EXR_ZIP_ROWS : 1;
  const blocks = Math.ceil(height / blockRows);
  cursor.slice(blocks * 8);
  for (let i = 0; i < blocks; i++) {
    const row = cursor.int() - top;
    if (row < 0 || row >= height || row % blockRows !== 0)
      throw new MessageError(msg`a block at row ${row} of ${height}`);
    const rows = Math.min(blockRows, height - row);
    unpackRows(inflate(cursor.slice(cursor.int()).rest(), rows * rowBytes), out, width, row, rows);
  }
  return out;
}

/** A block that deflate would not have shortened is stored as it is. */
function inflate(block: Uint8Array, size: number): Uint8Array {
  if (block.length === size) return block;
  const bytes = unzlibSync(block, { out: new Uint8Array(size) });
  if (bytes.length !== size) throw new MessageError(msg`a block of ${bytes.length} bytes where ${size} belong`);
  return unpredict(bytes);
}

/** The inverse of what the writer does before it compresses; `bytes` is overwritten. */
function unpredict(bytes: Uint8Array): Uint8Array {
  for (let i = 1; i < bytes.length; i++) bytes[i] = bytes[i] + bytes[i - 1] - 128;
  const out = new Uint8Array(bytes.length);
  const half = (bytes.length + 1) >> 1;
  for (let i = 0; i < out.length; i++) out[i] = bytes[(i & 1 ? half : 0) + (i >> 1)];
  return out;
}

function unpackRows(bytes: Uint8Array, out: readonly ExrChannel[], width: number, row: number, rows: number): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 0;
  for (let y = row; y < row + rows; y++) {
    for (const { type, data } of out) {
      for (let i = y * width; i < (y + 1) * width; i++, at += exrValueBytes(type)) {
        if (type === 'float') data[i] = view.getFloat32(at, true);
        else if (type === 'uint') data[i] = view.getUint32(at, true);
        else data[i] = fromHalf(view.getUint16(at, true));
      }
    }
  }
}

/** Reads little-endian values one after another; past the end it throws. */
class ByteCursor {
  private readonly bytes: Uint8Array;
  private readonly view: DataView;
  private at = 0;
  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }
  get left(): number {
    return this.bytes.length - this.at;
  }
  byte(): number {
    return this.view.getUint8(this.at++);
  }
  int(): number {
    this.at += 4;
    return this.view.getInt32(this.at - 4, true);
  }
  /** Up to a zero byte. */
  text(): string {
    const end = this.bytes.indexOf(0, this.at);
    if (end < 0 || end - this.at > 255) throw new MessageError(msg`a name without an end`);
    const text = new TextDecoder().decode(this.bytes.subarray(this.at, end));
    this.at = end + 1;
    return text;
  }
  slice(size: number): ByteCursor {
    if (size < 0 || size > this.left) throw new MessageError(msg`${size} bytes wanted, ${this.left} there`);
    this.at += size;
    return new ByteCursor(this.bytes.subarray(this.at - size, this.at));
  }
  rest(): Uint8Array {
    return this.bytes.subarray(this.at);
  }
}
