import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';

/** Longest code [bits]. */
const MAX_CODE = 16;
/** Codes up to this length are looked up at once [bits]. */
const QUICK = 9;

/** Reads numbers from bytes, the lowest bits first. */
export class BitReader {
  private readonly bytes: Uint8Array;
  private at = 0;
  private held = 0;
  private count = 0;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
  }

  /** The next bits, without taking them; beyond the end they are 0. At most 24. */
  peek(bits: number): number {
    while (this.count < bits) {
      this.held |= (this.bytes[this.at++] ?? 0) << this.count;
      this.count += 8;
    }
    return this.held & ((1 << bits) - 1);
  }

  /** Takes bits that have been looked at. */
  skip(bits: number): void {
    this.held >>>= bits;
    this.count -= bits;
    if (this.at - (this.count >> 3) > this.bytes.length) throw new MessageError(msg`it ends too early`);
  }

  /** At most 24. */
  read(bits: number): number {
    const value = this.peek(bits);
    this.skip(bits);
    return value;
  }

  /** A number in groups of so many bits, each followed by one that says whether there are more. */
  readVariable(bits: number): number {
    let value = 0;
    for (let shift = 0; shift < 32; shift += bits) {
      const group = this.read(bits + 1);
      value += (group & ((1 << bits) - 1)) * 2 ** shift;
      if (group >> bits === 0) return value;
    }
    throw new MessageError(msg`its codes are damaged`);
  }
}

/** A canonical Huffman code, of which the first bit read is the highest of a code word. */
export class HuffmanCode {
  /** By the next `QUICK` bits the symbol · 32 + its length; 0 where the code is longer. */
  private readonly quick = new Int32Array(1 << QUICK);
  /** By length: how many code words there are, and the first of them. */
  private readonly counts = new Int32Array(MAX_CODE + 1);
  /** Symbols in the order of their code words. */
  private readonly symbols: Uint16Array;

  /** `lengths`: by symbol [bits]; 0 for those that do not occur. */
  constructor(lengths: Uint8Array) {
    for (const length of lengths) if (length > 0) this.counts[length]++;
    const starts = new Int32Array(MAX_CODE + 2);
    let used = 0;
    for (let length = 1; length <= MAX_CODE; length++) {
      starts[length + 1] = starts[length] + this.counts[length];
      used += this.counts[length] * 2 ** (MAX_CODE - length);
    }
    if (used > 2 ** MAX_CODE) throw new MessageError(msg`its codes are damaged`);
    this.symbols = new Uint16Array(starts[MAX_CODE + 1]);
    const next = starts.slice();
    lengths.forEach((length, symbol) => {
      if (length > 0) this.symbols[next[length]++] = symbol;
    });
    this.fillQuick();
  }

  read(bits: BitReader): number {
    const found = this.quick[bits.peek(QUICK)];
    if (found > 0) {
      bits.skip(found & 31);
      return found >> 5;
    }
    const ahead = bits.peek(MAX_CODE);
    let [code, first, index] = [0, 0, 0];
    for (let length = 1; length <= MAX_CODE; length++) {
      code |= (ahead >> (length - 1)) & 1;
      const count = this.counts[length];
      if (code - first < count) {
        bits.skip(length);
        return this.symbols[index + code - first];
      }
      index += count;
      first = (first + count) << 1;
      code <<= 1;
    }
    throw new MessageError(msg`its codes are damaged`);
  }

  private fillQuick(): void {
    let [code, index] = [0, 0];
    for (let length = 1; length <= QUICK; length++) {
      for (let i = 0; i < this.counts[length]; i++, code++, index++) {
        const word = reversed(code, length);
        for (let high = 0; high < 1 << (QUICK - length); high++)
          this.quick[word | (high << length)] = (this.symbols[index] << 5) | length;
      }
      code <<= 1;
    }
  }
}

function reversed(code: number, length: number): number {
  let out = 0;
  for (let i = 0; i < length; i++) out |= ((code >> i) & 1) << (length - 1 - i);
  return out;
}
