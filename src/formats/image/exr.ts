import { zlibSync } from 'fflate';
import { toHalf } from '../../math/half.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/**
 * OpenEXR pictures, the part that Slowlight writes and reads back: one part, scan lines, whole-pixel channels of float,
 * half or uint, uncompressed or ZIP. Layout: https://openexr.com/en/latest/OpenEXRFileLayout.html
 */
export interface ExrImage {
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
  /** In any order; a name only once. */
  readonly channels: readonly ExrChannel[];
  /** Text in the header, by name. */
  readonly attributes?: Readonly<Record<string, string>>;
  /** Which environment map it is; absent: none. */
  readonly envmap?: ExrEnvmap;
}

/**
 * The standard attribute `envmap`. `latlong`: twice as wide as high, the whole sphere, seen from inside: the middle is +Z,
 * +X a quarter of the width left of it, +Y at the top. `cube`: six faces below each other, +X −X +Y −Y +Z −Z.
 * Source: OpenEXR, ImfEnvmap.h.
 */
export type ExrEnvmap = 'latlong' | 'cube';

/** One number per pixel. */
export interface ExrChannel {
  /** `R`, or with its layer `position.x`. */
  readonly name: string;
  /** How it is stored: 32 or 16 bits of floating point, or 32 bits unsigned. */
  readonly type: 'float' | 'half' | 'uint';
  /** One value per pixel, rows from the top. */
  readonly data: Float32Array | Uint32Array;
}

export const EXR_MAGIC = 20000630;
export const EXR_PIXEL_TYPES = ['uint', 'half', 'float'] as const;
/** By their number in the file. */
export const EXR_ENVMAPS: readonly ExrEnvmap[] = ['latlong', 'cube'];
export const EXR_ZIP = 3;
/** Rows that ZIP compresses together. */
export const EXR_ZIP_ROWS = 16;
/** OpenEXR's own default: as small as 6 to a percent, twice as fast. */
const ZIP_LEVEL = 4;
const LONG_NAMES = 0x400;

/** Bytes of one value. */
export const exrValueBytes = (type: ExrChannel['type']): number => (type === 'half' ? 2 : 4);
const byName = (a: { name: string }, b: { name: string }): number => (a.name < b.name ? -1 : a.name > b.name ? 1 : 0);

/**
 * Writes one picture, ZIP compressed; channels are sorted by name, as the format asks. Throws where a channel has not
 * a value for each pixel.
 * @example
 * const depth = { name: 'depth', type: 'float', data: new Float32Array([1.5, 2.5]) } as const;
 * const bytes = writeExr({ width: 2, height: 1, channels: [depth] });
 * readExr(bytes, 'depth.exr').channels[0].data; // [1.5, 2.5]
 */
export function writeExr(image: ExrImage): Uint8Array {
  const { width, height } = image;
  const channels = [...image.channels].sort(byName);
  checkImage(width, height, channels);
  const header = writeHeader(image, channels);
  const blocks: Uint8Array[] = [];
  for (let y = 0; y < height; y += EXR_ZIP_ROWS) {
    const raw = packRows(channels, width, y, Math.min(height, y + EXR_ZIP_ROWS));
    const zipped = zlibSync(predict(raw), { level: ZIP_LEVEL });
    blocks.push(zipped.length < raw.length ? zipped : raw);
  }
  return joinBlocks(header, blocks);
}

function checkImage(width: number, height: number, channels: readonly ExrChannel[]): void {
  if (!(width > 0 && height > 0)) throw new MessageError(msg`an EXR picture of ${width} × ${height} pixels cannot be`);
  for (const [i, { name, data }] of channels.entries()) {
    if (name === channels[i + 1]?.name) throw new MessageError(msg`two EXR channels are named ${name}`);
    if (data.length !== width * height) {
      throw new MessageError(msg`EXR channel ${name} has ${data.length} values for ${width} × ${height} pixels`);
    }
  }
}

function writeHeader({ width, height, attributes, envmap }: ExrImage, channels: readonly ExrChannel[]): Uint8Array {
  const texts = attributes ?? {};
  const out = new ByteWriter();
  const long = [...channels.map((c) => c.name), ...Object.keys(texts)].some(
    (n) => new TextEncoder().encode(n).length > 31,
  );
  out.int(EXR_MAGIC).int(2 | (long ? LONG_NAMES : 0));
  const list = new ByteWriter();
  for (const { name, type } of channels) list.text(name).int(EXR_PIXEL_TYPES.indexOf(type)).int(0).int(1).int(1);
  out.attribute('channels', 'chlist', list.byte(0).bytes());
  out.attribute('compression', 'compression', Uint8Array.of(EXR_ZIP));
  const window = new ByteWriter()
    .int(0)
    .int(0)
    .int(width - 1)
    .int(height - 1)
    .bytes();
  out.attribute('dataWindow', 'box2i', window);
  out.attribute('displayWindow', 'box2i', window);
  if (envmap) out.attribute('envmap', 'envmap', Uint8Array.of(EXR_ENVMAPS.indexOf(envmap)));
  out.attribute('lineOrder', 'lineOrder', Uint8Array.of(0));
  out.attribute('pixelAspectRatio', 'float', new ByteWriter().float(1).bytes());
  out.attribute('screenWindowCenter', 'v2f', new ByteWriter().float(0).float(0).bytes());
  out.attribute('screenWindowWidth', 'float', new ByteWriter().float(1).bytes());
  for (const [name, text] of Object.entries(texts)) out.attribute(name, 'string', new TextEncoder().encode(text));
  return out.byte(0).bytes();
}

/** Rows [from, to): in each row all values of the first channel, then of the second, … */
function packRows(channels: readonly ExrChannel[], width: number, from: number, to: number): Uint8Array {
  const rowBytes = channels.reduce((sum, c) => sum + width * exrValueBytes(c.type), 0);
  const bytes = new Uint8Array(rowBytes * (to - from));
  const view = new DataView(bytes.buffer);
  let at = 0;
  for (let y = from; y < to; y++) {
    for (const { type, data } of channels) {
      for (let i = y * width; i < (y + 1) * width; i++, at += exrValueBytes(type)) {
        if (type === 'float') view.setFloat32(at, data[i], true);
        else if (type === 'uint') view.setUint32(at, data[i], true);
        else view.setUint16(at, toHalf(data[i]), true);
      }
    }
  }
  return bytes;
}

/** Even bytes before odd ones, then the difference of neighbours, offset by 128: what deflate shortens best. */
function predict(raw: Uint8Array): Uint8Array {
  const out = new Uint8Array(raw.length);
  const half = (raw.length + 1) >> 1;
  for (let i = 0; i < raw.length; i++) out[(i & 1 ? half : 0) + (i >> 1)] = raw[i];
  for (let i = out.length - 1; i > 0; i--) out[i] = out[i] - out[i - 1] + 128;
  return out;
}

function joinBlocks(header: Uint8Array, blocks: readonly Uint8Array[]): Uint8Array {
  const start = header.length + blocks.length * 8;
  const out = new Uint8Array(blocks.reduce((sum, block) => sum + 8 + block.length, start));
  const view = new DataView(out.buffer);
  out.set(header);
  let at = start;
  for (const [i, block] of blocks.entries()) {
    view.setBigUint64(header.length + i * 8, BigInt(at), true);
    view.setInt32(at, i * EXR_ZIP_ROWS, true);
    view.setInt32(at + 4, block.length, true);
    out.set(block, at + 8);
    at += 8 + block.length;
  }
  return out;
}

/** Little-endian bytes that grow. */
class ByteWriter {
  private readonly buffer: number[] = [];
  byte(value: number): this {
    this.buffer.push(value & 255);
    return this;
  }
  int(value: number): this {
    return this.byte(value)
      .byte(value >> 8)
      .byte(value >> 16)
      .byte(value >> 24);
  }
  float(value: number): this {
    return this.int(new Int32Array(Float32Array.of(value).buffer)[0]);
  }
  /** Ends with a zero byte. */
  text(value: string): this {
    for (const byte of new TextEncoder().encode(value)) this.byte(byte);
    return this.byte(0);
  }
  attribute(name: string, type: string, value: Uint8Array): this {
    this.text(name).text(type).int(value.length);
    for (const byte of value) this.byte(byte);
    return this;
  }
  bytes(): Uint8Array {
    return Uint8Array.from(this.buffer);
  }
}
