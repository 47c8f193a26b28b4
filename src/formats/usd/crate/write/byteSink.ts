import { msg } from '../../../../messages/message.ts';
import { MessageError } from '../../../../messages/messageError.ts';
import { formatBytes } from '../../../diagnostics/inputError.ts';

const INITIAL_BYTES = 256;
/** The largest array of all platforms [bytes]. */
const MAX_BYTES = 2 ** 32 - 8;

/** Bytes that are appended to, little-endian. */
export class ByteSink {
  private buffer: Uint8Array<ArrayBuffer>;
  private view: DataView;
  private used = 0;

  /** `capacity` [bytes]: what is expected; it grows. */
  constructor(capacity = INITIAL_BYTES) {
    this.buffer = new Uint8Array(capacity);
    this.view = new DataView(this.buffer.buffer);
  }

  get length(): number {
    return this.used;
  }

  /** The bytes so far, until more are written. */
  get bytes(): Uint8Array<ArrayBuffer> {
    return this.buffer.subarray(0, this.used);
  }

  /** Makes room; returns where to write. */
  private take(size: number): number {
    const at = this.used;
    this.used = at + size;
    if (this.used > this.buffer.length) {
      if (this.used > MAX_BYTES)
        throw new MessageError(
          msg`a binary layer of more than ${formatBytes(MAX_BYTES)} cannot be written; write fewer samples, or fewer objects`,
        );
      const grown = new Uint8Array(Math.max(this.used, Math.min(MAX_BYTES, 2 * this.buffer.length)));
      grown.set(this.buffer.subarray(0, at));
      this.buffer = grown;
      this.view = new DataView(grown.buffer);
    }
    return at;
  }

  u8(value: number): void {
    const at = this.take(1);
    this.view.setUint8(at, value);
  }

  u16(value: number): void {
    const at = this.take(2);
    this.view.setUint16(at, value, true);
  }

  /** The low 32 bits of an integer, with or without sign. */
  u32(value: number): void {
    const at = this.take(4);
    this.view.setUint32(at, value, true);
  }

  /** A number that a double holds exactly, without sign. */
  u64(value: number): void {
    const at = this.take(8);
    this.view.setUint32(at, value % 2 ** 32, true);
    this.view.setUint32(at + 4, Math.floor(value / 2 ** 32), true);
  }

  big(value: bigint): void {
    const at = this.take(8);
    this.view.setBigUint64(at, BigInt.asUintN(64, value), true);
  }

  f32(value: number): void {
    const at = this.take(4);
    this.view.setFloat32(at, value, true);
  }

  f64(value: number): void {
    const at = this.take(8);
    this.view.setFloat64(at, value, true);
  }

  append(bytes: Uint8Array): void {
    const at = this.take(bytes.length);
    this.buffer.set(bytes, at);
  }

  /** Zeros up to a multiple of `size`. */
  align(size: number): void {
    const gap = (size - (this.used % size)) % size;
    const at = this.take(gap);
    this.buffer.fill(0, at, at + gap);
  }
}
