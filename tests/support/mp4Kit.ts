/** Small films of boxes (ISO/IEC 14496-12), made and taken apart without the program's own code. */

export const concat = (...parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(parts.flatMap((part) => [...part]));
export const u32 = (...values: readonly number[]): Uint8Array =>
  concat(...values.map((value) => Uint8Array.of(value >>> 24, value >>> 16, value >>> 8, value)));
const u64 = (value: number): Uint8Array => u32(Math.floor(value / 2 ** 32), value % 2 ** 32);
const ascii = (text: string): Uint8Array => new TextEncoder().encode(text);

export const box = (type: string, ...content: readonly Uint8Array[]): Uint8Array => {
  const all = concat(...content);
  return concat(u32(8 + all.length), ascii(type), all);
};
/** With its size in 64 bits. */
export const wideBox = (type: string, ...content: readonly Uint8Array[]): Uint8Array => {
  const all = concat(...content);
  return concat(u32(1), ascii(type), u64(16 + all.length), all);
};

export interface TestTrack {
  readonly handler: 'vide' | 'soun';
  /** Offsets in 64 bits. */
  readonly isWide: boolean;
}

/** Frames of 128 × 64 pixels. */
const visualEntry = (...boxes: readonly Uint8Array[]): Uint8Array =>
  box(
    'avc1',
    new Uint8Array(24),
    Uint8Array.of(0, 128, 0, 64),
    new Uint8Array(50),
    box('avcC', ascii('codec')),
    ...boxes,
  );

function track({ handler, isWide }: TestTrack, offsets: readonly number[], extra: readonly Uint8Array[]): Uint8Array {
  const isVideo = handler === 'vide';
  const entry = isVideo ? visualEntry(box('pasp', u32(1, 1))) : box('mp4a', new Uint8Array(28));
  const table = isWide
    ? box('co64', u32(0, offsets.length), ...offsets.map(u64))
    : box('stco', u32(0, offsets.length), u32(...offsets));
  const samples = box('stbl', box('stsd', u32(0, 1), entry), box('stsz', u32(0, 0, 0)), table, ...extra);
  return box(
    'trak',
    box('tkhd', new Uint8Array(84)),
    box('mdia', box('hdlr', u32(0, 0), ascii(handler), new Uint8Array(13)), box('minf', samples)),
  );
}

/** The `moov` of tracks with chunks at offsets; `extra` boxes are beside the tables of chunks. */
export const moovOf = (
  tracks: readonly TestTrack[],
  offsets: readonly (readonly number[])[],
  extra: readonly Uint8Array[] = [],
): Uint8Array =>
  box(
    'moov',
    box('mvhd', new Uint8Array(100)),
    ...tracks.map((each, i) => track(each, offsets[i] ?? [], extra)),
    box('udta', ascii('name')),
  );

/** A part of a film: its `moov`, free space of that many bytes, or chunks of tracks in a box of media. */
export type FilmPart =
  | 'moov'
  | { readonly free: number }
  | { readonly media: readonly { readonly track: number; readonly data: Uint8Array }[]; readonly isWide: boolean };

export interface TestFilm {
  readonly bytes: Uint8Array;
  /** Of each track, in order. */
  readonly chunks: readonly (readonly Uint8Array[])[];
}

/** A film of the parts in their order. */
export function filmOf(
  tracks: readonly TestTrack[],
  parts: readonly FilmPart[],
  extra: readonly Uint8Array[] = [],
): TestFilm {
  const counted = tracks.map((_, i) => parts.flatMap((part) => chunksIn(part, i)));
  const layOut = (offsets: readonly (readonly number[])[]): Uint8Array[] => [
    box('ftyp', ascii('isom'), u32(0), ascii('isom')),
    ...parts.map((part) => bytesOf(part, moovOf(tracks, offsets, extra))),
  ];
  const offsets = tracks.map((): number[] => []);
  let at = 0;
  for (const [i, bytes] of layOut(counted.map((chunks) => chunks.map(() => 0))).entries()) {
    const part = parts[i - 1];
    if (typeof part === 'object' && 'media' in part) {
      let chunk = at + (part.isWide ? 16 : 8);
      for (const { track: of, data } of part.media) {
        offsets[of].push(chunk);
        chunk += data.length;
      }
    }
    at += bytes.length;
  }
  return { bytes: concat(...layOut(offsets)), chunks: counted };
}

const chunksIn = (part: FilmPart, track: number): Uint8Array[] =>
  typeof part === 'object' && 'media' in part
    ? part.media.flatMap((chunk) => (chunk.track === track ? [chunk.data] : []))
    : [];

function bytesOf(part: FilmPart, moov: Uint8Array): Uint8Array {
  if (part === 'moov') return moov;
  if ('free' in part) return box('free', new Uint8Array(part.free - 8));
  const data = part.media.map((chunk) => chunk.data);
  return part.isWide ? wideBox('mdat', ...data) : box('mdat', ...data);
}

/** The boxes of a file or of the content of a box. */
export function boxesIn(bytes: Uint8Array): { readonly type: string; readonly content: Uint8Array }[] {
  const found: { type: string; content: Uint8Array }[] = [];
  for (let at = 0; at < bytes.length; ) {
    const view = new DataView(bytes.buffer, bytes.byteOffset + at);
    const isWide = view.getUint32(0) === 1;
    const size = isWide ? Number(view.getBigUint64(8)) : view.getUint32(0);
    if (size < 8 || at + size > bytes.length) throw new Error(`box of ${size} bytes at ${at} of ${bytes.length}`);
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    found.push({ type, content: bytes.subarray(at + (isWide ? 16 : 8), at + size) });
    at += size;
  }
  return found;
}

/** The contents of all boxes on a path. */
export const inside = (bytes: Uint8Array, ...path: readonly string[]): Uint8Array[] =>
  path.reduce<Uint8Array[]>(
    (contents, type) =>
      contents.flatMap((content) => boxesIn(content).flatMap((each) => (each.type === type ? [each.content] : []))),
    [bytes],
  );

/** Where the chunks of each track are, as the film says. */
export const chunkStarts = (film: Uint8Array): number[][] =>
  inside(film, 'moov', 'trak').map((content) => {
    const tables = boxesIn(inside(content, 'mdia', 'minf', 'stbl')[0]);
    return tables.flatMap(({ type, content: table }) => {
      const view = new DataView(table.buffer, table.byteOffset, table.byteLength);
      const numbers = (width: number) => Array.from({ length: view.getUint32(4) }, (_, i) => 8 + width * i);
      if (type === 'stco') return numbers(4).map((at) => view.getUint32(at));
      return type === 'co64' ? numbers(8).map((at) => Number(view.getBigUint64(at))) : [];
    });
  });
