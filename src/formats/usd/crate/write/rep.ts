/** Flags of a value's representation: it is an array, lies in the representation itself, is compressed. */
const [ARRAY, INLINED, COMPRESSED] = [0x80, 0x40, 0x20];

const repOf = (flags: number, type: number, payload: bigint): bigint => (BigInt((flags << 8) | type) << 48n) | payload;

/** A representation that is the value itself, in 32 bits. */
export const inlined = (type: number, bits: number): bigint => repOf(INLINED, type, BigInt(bits >>> 0));

/** Of a value that lies in the file. */
export const stored = (type: number, at: number): bigint => repOf(0, type, BigInt(at));

/** Of an array; empty ones lie nowhere, at 0. */
export const storedArray = (type: number, at: number, isCompressed: boolean): bigint =>
  repOf(ARRAY | (isCompressed ? COMPRESSED : 0), type, BigInt(at));
