import { ByteSink } from './byteSink.ts';
import { compress } from './lz4.ts';

/**
 * Integers of 32 bits as a crate has them (OpenUSD, Sdf_IntegerCompression): their differences in 0, 8, 16 or 32 bits,
 * two bits each saying which, compressed. No bits stand for the commonest difference, which comes first.
 */
export function packInt32s(values: ArrayLike<number>): Uint8Array {
  const differences = new Int32Array(values.length);
  for (let i = 0; i < differences.length; i++) differences[i] = values[i] - (i > 0 ? values[i - 1] : 0);
  const common = commonest(differences, 0);
  const codes = new Uint8Array(Math.ceil(differences.length / 4));
  const sink = new ByteSink();
  for (const [i, d] of differences.entries()) {
    if (d === common) continue;
    const code = d === (d << 24) >> 24 ? 1 : d === (d << 16) >> 16 ? 2 : 3;
    codes[i >> 2] |= code << (2 * (i & 3));
    if (code === 1) sink.u8(d);
    else if (code === 2) sink.u16(d);
    else sink.u32(d);
  }
  const head = new ByteSink();
  head.u32(common);
  return packed(head, codes, sink);
}

/** The same of 64 bits: differences in 0, 16, 32 or 64 bits. */
export function packInt64s(values: BigInt64Array | BigUint64Array): Uint8Array {
  const differences = BigInt64Array.from(values, (value, i) =>
    BigInt.asIntN(64, i > 0 ? value - values[i - 1] : value),
  );
  const common = commonest(differences, 0n);
  const codes = new Uint8Array(Math.ceil(differences.length / 4));
  const sink = new ByteSink();
  for (const [i, d] of differences.entries()) {
    if (d === common) continue;
    const code = BigInt.asIntN(16, d) === d ? 1 : BigInt.asIntN(32, d) === d ? 2 : 3;
    codes[i >> 2] |= code << (2 * (i & 3));
    if (code === 3) sink.big(d);
    else if (code === 2) sink.u32(Number(d));
    else sink.u16(Number(d));
  }
  const head = new ByteSink();
  head.big(common);
  return packed(head, codes, sink);
}

/** The value that occurs most; of equal ones that which did so first. `otherwise`: of none. */
function commonest<T>(values: Iterable<T>, otherwise: T): T {
  const counts = new Map<T, number>();
  let [best, most] = [otherwise, 0];
  for (const value of values) {
    const count = (counts.get(value) ?? 0) + 1;
    counts.set(value, count);
    if (count > most) [best, most] = [value, count];
  }
  return best;
}

function packed(head: ByteSink, codes: Uint8Array, differences: ByteSink): Uint8Array {
  // Of no numbers there is not even a commonest difference.
  if (codes.length === 0) return compress(codes);
  head.append(codes);
  head.append(differences.bytes);
  return compress(head.bytes);
}

/** Compressed integers, with their size [bytes] before them. */
export function writeInt32s(sink: ByteSink, values: ArrayLike<number>): void {
  writeSized(sink, packInt32s(values));
}

export function writeSized(sink: ByteSink, bytes: Uint8Array): void {
  sink.u64(bytes.length);
  sink.append(bytes);
}
