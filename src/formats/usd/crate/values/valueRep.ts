import { msg } from '../../../../messages/message.ts';
import type { CrateSource } from '../structure/crateSource.ts';

/**
 * A value's representation: 48 bits that are the value itself (`isInlined`) or where it is in the file, its type, and
 * how it is kept.
 */
export class ValueRep {
  /** The low 32 bits. */
  readonly low: number;
  /** Type and flags. */
  readonly typeAndFlags: number;
  /** The 48 bits: where the value is, if it is not inlined. */
  readonly offset: number;
  /** Where the representation itself is, if not in a section. */
  readonly at: number | undefined;

  /** Of the two halves. Array edits (crate 0.14) are refused. */
  constructor(source: CrateSource, low: number, top: number, at?: number) {
    this.low = low;
    this.typeAndFlags = top >>> 16;
    this.offset = (top & 0xffff) * 2 ** 32 + low;
    this.at = at;
    if (this.typeAndFlags & 0x1000)
      source.fail(msg`an array edit (crate 0.14) is not read; flatten it: usdcat --flatten in.usdc -o out.usda`, at);
  }

  get type(): number {
    return this.typeAndFlags & 0xff;
  }

  get isArray(): boolean {
    return (this.typeAndFlags & 0x8000) !== 0;
  }

  get isInlined(): boolean {
    return (this.typeAndFlags & 0x4000) !== 0;
  }

  get isCompressed(): boolean {
    return (this.typeAndFlags & 0x2000) !== 0;
  }
}
