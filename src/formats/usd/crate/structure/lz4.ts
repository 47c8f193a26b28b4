import { msg } from '../../../../messages/message.ts';
import type { CrateSource } from './crateSource.ts';

/** Maximum compression ratio of LZ4. */
export const MAX_EXPANSION = 255;

/**
 * Decompresses `length` bytes of the file from `at` into `out`; returns how many bytes came. They are one LZ4 block, or
 * several with their sizes before them (OpenUSD, TfFastCompression).
 */
export function decompress(source: CrateSource, at: number, length: number, out: Uint8Array): number {
  source.require(at, length, msg`compressed data`);
  if (length === 0) return source.fail(msg`compressed data of no bytes`, at);
  const end = at + length;
  const chunks = source.bytes[at - source.base];
  if (chunks === 0) return decompressBlock(source, at + 1, end, out, 0);
  let from = at + 1;
  let written = 0;
  for (let i = 0; i < chunks; i++) {
    source.require(from, 4, msg`the size of a compressed chunk`);
    const size = source.view.getInt32(from - source.base, true);
    from += 4;
    if (size < 0 || from + size > end) source.fail(msg`a compressed chunk says ${size} bytes, past its end`, from - 4);
    written = decompressBlock(source, from, from + size, out, written);
    from += size;
  }
  return written;
}

/** One LZ4 block (LZ4 block format): literals, then a match earlier in the output, over and over. */
function decompressBlock(source: CrateSource, start: number, stop: number, out: Uint8Array, begin: number): number {
  const { bytes, base } = source;
  const end = stop - base;
  let from = start - base;
  let to = begin;
  /** A length of 15 continues in bytes, up to the first that is not 255. */
  const longer = (nibble: number): number => {
    if (nibble !== 15) return nibble;
    let length = 15;
    for (;;) {
      if (from >= end) source.fail(msg`compressed data ends in the middle of a length`, base + from);
      const more = bytes[from++];
      length += more;
      if (more !== 255) return length;
    }
  };
  while (from < end) {
    const token = bytes[from++];
    const literals = longer(token >> 4);
    if (from + literals > end || to + literals > out.length)
      source.fail(msg`compressed data has ${literals} bytes that do not fit`, base + from);
    copyLiterals(bytes, from, out, to, literals);
    from += literals;
    to += literals;
    if (from === end) return to;
    if (from + 2 > end) source.fail(msg`compressed data ends in the middle of a match`, base + from);
    const distance = bytes[from] | (bytes[from + 1] << 8);
    from += 2;
    const length = longer(token & 15) + 4;
    if (distance === 0 || distance > to - begin || to + length > out.length)
      source.fail(msg`compressed data repeats ${length} bytes from ${distance} before, which it has not`, base + from);
    copyMatch(out, to, distance, length);
    to += length;
  }
  return to;
}

/** Below this length a loop is faster than the platform’s copy. */
const MIN_BULK_COPY = 24;

function copyLiterals(bytes: Uint8Array, from: number, out: Uint8Array, to: number, length: number): void {
  if (length > MIN_BULK_COPY) out.set(bytes.subarray(from, from + length), to);
  else for (let i = 0; i < length; i++) out[to + i] = bytes[from + i];
}

/** Overlapping matches repeat. */
function copyMatch(out: Uint8Array, to: number, distance: number, length: number): void {
  if (length > MIN_BULK_COPY && distance >= length) out.copyWithin(to, to - distance, to - distance + length);
  else if (length > MIN_BULK_COPY && distance === 1) out.fill(out[to - 1], to, to + length);
  else for (let i = 0; i < length; i++) out[to + i] = out[to + i - distance];
}
