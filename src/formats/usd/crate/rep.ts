import type { CrateSource } from './source.ts';

/**
 * A value's representation: 48 bits that are the value itself (`isInlined`) or where it is in the file, its type, and
 * how it is kept.
 */
export interface Rep {
  readonly type: number;
  readonly isArray: boolean;
  readonly isInlined: boolean;
  readonly isCompressed: boolean;
  /** Of the 48 bits, the low 32 and the high 16. */
  readonly low: number;
  readonly high: number;
  /** Where the value is, if it is not inlined. */
  readonly offset: number;
  /** Type and flags. */
  readonly kind: number;
  /** Where the representation itself is, if not in a section. */
  readonly at: number | undefined;
}

/** Splits the two halves of a representation. Array edits (crate 0.14) are refused. */
export function repOf(source: CrateSource, low: number, top: number, at?: number): Rep {
  const kind = top >>> 16;
  const high = top & 0xffff;
  if (kind & 0x1000)
    source.fail('an array edit (crate 0.14) is not read; flatten it: usdcat --flatten in.usdc -o out.usda', at);
  return {
    type: kind & 0xff,
    isArray: (kind & 0x8000) !== 0,
    isInlined: (kind & 0x4000) !== 0,
    isCompressed: (kind & 0x2000) !== 0,
    low,
    high,
    offset: high * 2 ** 32 + low,
    kind,
    at,
  };
}
