import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';

/** A sequential byte reader; throws an Error that names the byte where it would pass `end`. */
export class ByteReader {
  at: number;
  private readonly bytes: Uint8Array;
  private readonly end: number;
  constructor(bytes: Uint8Array, at: number, end: number) {
    this.bytes = bytes;
    this.at = at;
    this.end = end;
  }

  byte(): number {
    if (this.at >= this.end) throw this.short(1);
    return this.bytes[this.at++];
  }

  /** The next `count` bytes, not copied. */
  take(count: number): Uint8Array {
    if (this.at + count > this.end) throw this.short(count);
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }

  /** LEB128: seven bits a byte, lowest first, truncated to 32 bits. */
  varint(): number {
    let value = 0;
    for (let shift = 0; shift < 35; shift += 7) {
      const byte = this.byte();
      value |= (byte & 0x7f) << shift;
      if (byte < 0x80) return value >>> 0;
    }
    throw new MessageError(msg`a number of more than 5 bytes ends at byte ${this.at}`);
  }

  private short(wanted: number): Error {
    return new MessageError(msg`wants ${wanted} more bytes at byte ${this.at}, but the data ends at ${this.end}`);
  }
}

/** 0, 1, 2, 3 … → 0, −1, 1, −2 … */
export const unzigzag = (v: number): number => (v >>> 1) ^ -(v & 1);
