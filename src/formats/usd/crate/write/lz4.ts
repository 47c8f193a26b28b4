import { msg } from '../../../../messages/message.ts';
import { MessageError } from '../../../../messages/messageError.ts';

/** LZ4 block format: a match is of at least 4 bytes, begins 12 or more before the end and ends 5 or more before it. */
const MIN_MATCH = 4;
const LAST_MATCH_START = 12;
const LAST_LITERALS = 5;
const MAX_DISTANCE = 65535;

/** Matches of this length are taken at once; of shorter ones, the longest of so many candidates. */
const GOOD_LENGTH = 64;
const MAX_CANDIDATES = 8;

/** Maximum size of one LZ4 block (LZ4_MAX_INPUT_SIZE) [bytes]. */
const MAX_BLOCK_BYTES = 0x7e000000;

/** Data as one LZ4 block after a zero byte (OpenUSD, TfFastCompression: no chunks). */
export function compress(data: Uint8Array): Uint8Array {
  if (data.length > MAX_BLOCK_BYTES) throw new MessageError(msg`${data.length} bytes are more than an LZ4 block holds`);
  // Incompressible data grows by one byte in 255, and a few.
  const out = new Uint8Array(data.length + Math.ceil(data.length / 255) + 17);
  return out.subarray(0, compressBlock(data, out, 1));
}

/** Writes one block from `start` on; returns where it ends. */
function compressBlock(data: Uint8Array, out: Uint8Array, start: number): number {
  const matches = new MatchFinder(data);
  const lastStart = data.length - LAST_MATCH_START;
  let to = start;
  /** Where the literals that are not yet written begin. */
  let from = 0;
  for (let at = 0; at <= lastStart; ) {
    const { length, distance } = matches.longest(at);
    if (length < MIN_MATCH) {
      matches.add(at++);
      continue;
    }
    to = writeSequence(data.subarray(from, at), length, distance, out, to);
    for (const end = at + length; at < end; at++) if (at <= lastStart) matches.add(at);
    from = at;
  }
  return writeLiterals(data.subarray(from), 0, out, to);
}

/** Earlier positions with the same four bytes, newest first. */
class MatchFinder {
  private readonly data: Uint8Array;
  private readonly heads: Int32Array;
  private readonly previous: Int32Array;
  private readonly shift: number;
  private readonly found = { length: 0, distance: 0 };

  constructor(data: Uint8Array) {
    this.data = data;
    const bits = Math.min(16, Math.max(6, 32 - Math.clz32(data.length)));
    this.shift = 32 - bits;
    this.heads = new Int32Array(2 ** bits).fill(-1);
    this.previous = new Int32Array(data.length);
  }

  /** Fibonacci hashing of the four bytes at a position. */
  private slot(at: number): number {
    const { data } = this;
    const word = data[at] | (data[at + 1] << 8) | (data[at + 2] << 16) | (data[at + 3] << 24);
    return Math.imul(word, 0x9e3779b1) >>> this.shift;
  }

  add(at: number): void {
    const slot = this.slot(at);
    this.previous[at] = this.heads[slot];
    this.heads[slot] = at;
  }

  /** The longest match at a position among the newest; of equal ones the nearest. Valid until the next call. */
  longest(at: number): { readonly length: number; readonly distance: number } {
    const { found, previous } = this;
    const limit = this.data.length - LAST_LITERALS;
    found.length = 0;
    let candidate = this.heads[this.slot(at)];
    for (let i = 0; i < MAX_CANDIDATES && candidate >= 0 && at - candidate <= MAX_DISTANCE; i++) {
      const length = this.commonLength(candidate, at, limit);
      if (length > found.length) [found.length, found.distance] = [length, at - candidate];
      if (length >= GOOD_LENGTH) break;
      candidate = previous[candidate];
    }
    return found;
  }

  private commonLength(a: number, b: number, limit: number): number {
    const { data } = this;
    let end = b;
    while (end < limit && data[a + end - b] === data[end]) end++;
    return end - b;
  }
}

function writeSequence(literals: Uint8Array, length: number, distance: number, out: Uint8Array, start: number): number {
  const rest = length - MIN_MATCH;
  let to = writeLiterals(literals, Math.min(15, rest), out, start);
  out[to++] = distance & 255;
  out[to++] = distance >> 8;
  return rest < 15 ? to : writeLength(rest - 15, out, to);
}

function writeLiterals(literals: Uint8Array, match: number, out: Uint8Array, start: number): number {
  const { length } = literals;
  let to = start;
  out[to++] = (Math.min(15, length) << 4) | match;
  if (length >= 15) to = writeLength(length - 15, out, to);
  out.set(literals, to);
  return to + length;
}

/** What is above 15 of a length: bytes of 255, and the rest. */
function writeLength(rest: number, out: Uint8Array, start: number): number {
  const full = Math.floor(rest / 255);
  out.fill(255, start, start + full);
  out[start + full] = rest % 255;
  return start + full + 1;
}
