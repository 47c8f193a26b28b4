import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { crc32 } from '../files/crc32.ts';

/** Behind the signature and the header, which comes first. */
const AFTER_HEADER = 8 + 25;

/** A chunk of a PNG (W3C Portable Network Graphics, third edition, 5.3). */
export interface PngChunk {
  /** Four letters. */
  readonly type: string;
  /** Without length, type and checksum. */
  readonly content: Uint8Array;
  /** Of the whole chunk in the file [bytes]. */
  readonly from: number;
  readonly to: number;
}

/** The bytes of a chunk. */
export function pngChunk(type: string, content: Uint8Array): Uint8Array {
  const chunk = new Uint8Array(content.length + 12);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, content.length);
  for (let i = 0; i < 4; i++) chunk[4 + i] = type.charCodeAt(i);
  chunk.set(content, 8);
  view.setUint32(8 + content.length, crc32(chunk.subarray(4, 8 + content.length)));
  return chunk;
}

/** A PNG with further chunks behind its header. */
export function withPngChunks(png: Uint8Array, chunks: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(png.length + chunks.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of [png.subarray(0, AFTER_HEADER), ...chunks, png.subarray(AFTER_HEADER)]) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/** The chunks of a PNG up to IEND, whose checksums are not verified. Throws where one is cut off. */
export function* pngChunks(png: Uint8Array): Generator<PngChunk> {
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
  for (let at = 8, type = ''; type !== 'IEND'; ) {
    const length = at + 12 > png.length ? Number.POSITIVE_INFINITY : view.getUint32(at);
    const to = at + 12 + length;
    if (to > png.length) throw new MessageError(msg`the PNG is cut off in the chunk at byte ${at}; copy it again`);
    type = String.fromCharCode(...png.subarray(at + 4, at + 8));
    yield { type, content: png.subarray(at + 8, to - 4), from: at, to };
    at = to;
  }
}
