import { ByteSink } from './byteSink.ts';

/** Arrays of numbers begin at multiples of this, so that they can be used where they lie in a mapped file [bytes]. */
export const ARRAY_ALIGNMENT = 8;

interface StoredValue {
  readonly at: number;
  readonly size: number;
}

/** Values that lie in the file, each once: equal bytes are found by their hash. */
export class ValueStore {
  private readonly sink = new ByteSink();
  private readonly start: number;
  private readonly known = new Map<number, StoredValue[]>();

  /** `start`: where its bytes begin in the file. */
  constructor(start: number) {
    this.start = start;
  }

  get bytes(): Uint8Array<ArrayBuffer> {
    return this.sink.bytes;
  }

  /** Where in the file these bytes are. */
  place(value: Uint8Array, alignment = 1): number {
    const hash = hashOf(value);
    const alike = this.known.get(hash) ?? [];
    this.known.set(hash, alike);
    const found = alike.find(({ at, size }) => {
      return size === value.length && (this.start + at) % alignment === 0 && this.holds(at, value);
    });
    if (found) return this.start + found.at;
    if (alignment > 1) this.sink.align(alignment);
    const at = this.sink.length;
    this.sink.append(value);
    alike.push({ at, size: value.length });
    return this.start + at;
  }

  private holds(at: number, value: Uint8Array): boolean {
    const { bytes } = this.sink;
    for (let i = 0; i < value.length; i++) if (bytes[at + i] !== value[i]) return false;
    return true;
  }
}

/** 32 bits that differ for most different values: words mixed as in MurmurHash3. */
function hashOf(bytes: Uint8Array): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  let hash = bytes.length;
  let at = 0;
  for (; at + 4 <= bytes.length; at += 4) hash = mix(hash, view.getInt32(at, true));
  for (; at < bytes.length; at++) hash = mix(hash, bytes[at]);
  return hash;
}

function mix(hash: number, word: number): number {
  const k = Math.imul(word, 0xcc9e2d51);
  const h = hash ^ Math.imul((k << 15) | (k >>> 17), 0x1b873593);
  return (Math.imul((h << 13) | (h >>> 19), 5) + 0xe6546b64) | 0;
}
