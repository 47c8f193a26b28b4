import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';

/** Bits of codes that are found by one look into a table; longer ones are searched by length. */
const SHORT = 9;
const LONGEST = 16;

/** Codes of a Huffman table (ITU T.81 annex C). */
export interface HuffmanTable {
  /** By the next 9 bits: length · 256 + value of the code that they begin with; 0: it is longer. */
  readonly short: Uint16Array;
  /** By length: the greatest code; −1: none. */
  readonly greatest: Int32Array;
  /** By length: index of a code's value minus the code. */
  readonly offsets: Int32Array;
  readonly values: Uint8Array;
}

/** `counts`: of codes of each length, 1 to 16. */
export function makeHuffmanTable(counts: Uint8Array, values: Uint8Array): HuffmanTable {
  const short = new Uint16Array(2 ** SHORT);
  const greatest = new Int32Array(LONGEST + 1).fill(-1);
  const offsets = new Int32Array(LONGEST + 1);
  let [code, index] = [0, 0];
  for (let length = 1; length <= LONGEST; length++, code *= 2) {
    offsets[length] = index - code;
    for (let n = 0; n < counts[length - 1]; n++, code++, index++) {
      if (code >= 2 ** length) throw damaged();
      if (length > SHORT) continue;
      const first = code << (SHORT - length);
      short.fill((length << 8) | values[index], first, first + 2 ** (SHORT - length));
    }
    if (counts[length - 1] > 0) greatest[length] = code - 1;
  }
  return { short, greatest, offsets, values };
}

/** Reads the bits of one scan between two markers. */
export class EntropyBits {
  /** Offset of the next byte. */
  at: number;
  private readonly bytes: Uint8Array;
  /** The last `count` bits are not read yet. */
  private buffer = 0;
  private count = 0;
  /** How many of them are zeros that were added at the end. */
  private added = 0;

  constructor(bytes: Uint8Array, at: number) {
    this.bytes = bytes;
    this.at = at;
  }

  /** Drops what is left before a marker. */
  restart(): void {
    this.buffer = this.count = this.added = 0;
  }

  /** Throws if more has been read than there is. */
  check(): void {
    if (this.count < this.added) throw damaged();
  }

  symbol({ short, greatest, offsets, values }: HuffmanTable): number {
    if (this.count < LONGEST) this.fill();
    const next = (this.buffer >>> (this.count - LONGEST)) & 0xffff;
    const found = short[next >>> (LONGEST - SHORT)];
    if (found > 0) {
      this.count -= found >>> 8;
      return found & 255;
    }
    for (let length = SHORT + 1; length <= LONGEST; length++) {
      const code = next >>> (LONGEST - length);
      if (code > greatest[length]) continue;
      this.count -= length;
      return values[offsets[length] + code];
    }
    throw damaged();
  }

  /** An unsigned number of up to 16 bits. */
  bits(size: number): number {
    if (size === 0) return 0;
    if (this.count < LONGEST) this.fill();
    this.count -= size;
    return (this.buffer >>> this.count) & ((1 << size) - 1);
  }

  /** A signed one, as T.81 F.2.2.1 extends it. */
  signed(size: number): number {
    if (size > LONGEST) throw damaged();
    const n = this.bits(size);
    return size > 0 && n < 1 << (size - 1) ? n + 1 - (1 << size) : n;
  }

  private fill(): void {
    const { bytes } = this;
    while (this.count <= 24) {
      const byte = bytes[this.at];
      const isData = this.at < bytes.length && (byte !== 0xff || bytes[this.at + 1] === 0);
      if (isData) this.at += byte === 0xff ? 2 : 1;
      else this.added += 8;
      this.buffer = (this.buffer << 8) | (isData ? byte : 0);
      this.count += 8;
    }
  }
}

export const damaged = (): MessageError => new MessageError(msg`its codes end too early or are in none of its tables`);
