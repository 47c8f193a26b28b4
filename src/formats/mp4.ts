/**
 * Films in MP4 files: one track of pictures that are encoded already, all that a player needs before the first of them.
 * Boxes: ISO/IEC 14496-12; H.264 in them: 14496-15; VP9: https://www.webmproject.org/vp9/mp4/
 */
export interface Film {
  readonly width: number;
  readonly height: number;
  /** Frames per second, all of one length. */
  readonly fps: number;
  readonly codec: FilmCodec;
  /** In the order in which they are to be decoded. */
  readonly frames: readonly EncodedFrame[];
}

export type FilmCodec =
  /** `description`: the AVCDecoderConfigurationRecord. */
  | { readonly kind: 'h264'; readonly description: Uint8Array }
  /** Profile 0: 8 bits, 4:2:0. `level`: 51 is 5.1. */
  | { readonly kind: 'vp9'; readonly level: number };

export interface EncodedFrame {
  readonly data: Uint8Array;
  /** Can be decoded by itself. */
  readonly key: boolean;
  /** Its place in the order in which they are seen. */
  readonly place: number;
}

/** Units of time in a frame. */
const TICKS = 1000;
/** BT.709, limited range (ITU-T H.273: primaries, transfer and matrix 1). */
const BT709 = [0, 1, 0, 1, 0, 1] as const;

/** The parts of the file, to be put one behind the other: its pictures are not copied. */
export function mp4(film: Film): Uint8Array<ArrayBuffer>[] {
  const begin = box('ftyp', text('isom'), u32(0x200), text('isomiso2mp41'));
  const size = film.frames.reduce((sum, { data }) => sum + data.length, 0);
  // Where the pictures begin is told in a box whose length does not depend on it.
  const start = begin.length + movie(film, 0).length + MEDIA_HEADER;
  const media = bytes(u32(1), text('mdat'), u64(size + MEDIA_HEADER));
  return [begin, movie(film, start), media, ...film.frames.map(({ data }) => data.slice())];
}
/** Of a box whose length is told in 64 bits. */
const MEDIA_HEADER = 16;

function movie(film: Film, start: number): Uint8Array<ArrayBuffer> {
  const { width, height, frames } = film;
  const scale = Math.round(film.fps * TICKS);
  const length = frames.length * TICKS;
  const times = (...between: Uint8Array[]) => bytes(u64(0), u64(0), ...between, u64(length));
  const identity = [0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000].map(u32);
  const movieHeader = full(
    'mvhd',
    1,
    0,
    times(u32(scale)),
    u32(0x10000),
    u16(0x100),
    zeros(10),
    ...identity,
    zeros(24),
    u32(2),
  );
  const trackHeader = full(
    'tkhd',
    ...([1, 3, times(u32(1), u32(0)), zeros(16), ...identity, u32(width * 0x10000), u32(height * 0x10000)] as const),
  );
  const mediaHeader = full('mdhd', 1, 0, times(u32(scale)), u16(0x55c4), u16(0));
  const handler = full('hdlr', 0, 0, u32(0), text('vide'), zeros(12), text('Pictures\0'));
  const here = box('dinf', full('dref', 0, 0, u32(1), full('url ', 0, 1)));
  const information = box('minf', full('vmhd', 0, 1, zeros(8)), here, table(film, start));
  const media = box('mdia', mediaHeader, handler, information);
  return box('moov', movieHeader, box('trak', trackHeader, media));
}

/** Where each picture is, how long it is and when it is seen. All lie in one chunk. */
function table(film: Film, start: number): Uint8Array<ArrayBuffer> {
  const { frames } = film;
  const keys = frames.flatMap(({ key }, i) => (key ? [u32(i + 1)] : []));
  const offsets = frames.map(({ place }, i) => bytes(u32(1), u32((place - i) * TICKS)));
  const isInOrder = frames.every(({ place }, i) => place === i);
  return box(
    'stbl',
    full('stsd', 0, 0, u32(1), sampleEntry(film)),
    full('stts', 0, 0, u32(1), u32(frames.length), u32(TICKS)),
    ...(isInOrder ? [] : [full('ctts', 1, 0, u32(frames.length), ...offsets)]),
    full('stss', 0, 0, u32(keys.length), ...keys),
    full('stsc', 0, 0, u32(1), u32(1), u32(frames.length), u32(1)),
    full('stsz', 0, 0, u32(0), u32(frames.length), ...frames.map(({ data }) => u32(data.length))),
    full('co64', 0, 0, u32(1), u64(start)),
  );
}

function sampleEntry({ codec, width, height }: Film): Uint8Array<ArrayBuffer> {
  const resolution = bytes(u32(72 * 0x10000), u32(72 * 0x10000));
  const visual = [zeros(6), u16(1), zeros(16), u16(width), u16(height), resolution, u32(0), u16(1), zeros(32)];
  const depth = [u16(24), u16(0xffff)];
  const colour = box('colr', text('nclx'), Uint8Array.of(...BT709, 0));
  return codec.kind === 'h264'
    ? box('avc1', ...visual, ...depth, box('avcC', codec.description), colour)
    : box('vp09', ...visual, ...depth, full('vpcC', 1, 0, Uint8Array.of(0, codec.level, 0x82, 1, 1, 1, 0, 0)), colour);
}

function box(type: string, ...content: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const inside = bytes(...content);
  return bytes(u32(8 + inside.length), text(type), inside);
}

const full = (type: string, version: number, flags: number, ...content: readonly Uint8Array[]) =>
  box(type, u32(version * 2 ** 24 + flags), ...content);

function bytes(...parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

const zeros = (length: number): Uint8Array => new Uint8Array(length);
const u16 = (value: number): Uint8Array => Uint8Array.of(value >> 8, value);
const u32 = (value: number): Uint8Array => Uint8Array.of(value >>> 24, value >>> 16, value >>> 8, value);
const u64 = (value: number): Uint8Array => bytes(u32(Math.floor(value / 2 ** 32)), u32(value % 2 ** 32));
const text = (value: string): Uint8Array => Uint8Array.from(value, (letter) => letter.charCodeAt(0));
