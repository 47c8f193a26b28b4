import { fromHalf } from '../../math/half.ts';

/**
 * A file of which parts can be read at any time, as plain data, so that it can be sent to other threads. `handle` is what
 * the host's own reader understands: a path on disk, a `File` of the page, or bytes in memory.
 */
export interface StoredFile {
  /** For messages. */
  readonly name: string;
  readonly handle: unknown;
}

/** Numbers that were left in a file: little-endian, one after the other. */
export interface StoredNumbers {
  readonly file: StoredFile;
  /** Byte at which they begin. */
  readonly at: number;
  readonly count: number;
  readonly scalar: 'half' | 'float' | 'double';
}

/** Reads `length` bytes of a file from `at` on, into memory of their own. Throws an InputError where the file has them no more. */
export type ReadRange = (file: StoredFile, at: number, length: number) => Uint8Array<ArrayBuffer>;

const NUMBER_BYTES = { half: 2, float: 4, double: 8 } as const;

export const storedByteLength = ({ count, scalar }: Pick<StoredNumbers, 'count' | 'scalar'>): number =>
  count * NUMBER_BYTES[scalar];

let hostReads: ReadRange | undefined;

/** How this thread reads files that are not in memory: each kind of thread says it once, at its start. */
export function setFileReader(read: ReadRange): void {
  hostReads = read;
}

export function readRange(file: StoredFile, at: number, length: number): Uint8Array<ArrayBuffer> {
  const { handle } = file;
  if (handle instanceof Uint8Array) return copyOf(handle.subarray(at, at + length));
  if (!hostReads) throw new Error(`this thread was not told how to read ${file.name}`);
  return hostReads(file, at, length);
}

/** Also of a Buffer of Node, whose slices are no copies. */
function copyOf(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const copy = new Uint8Array(bytes.length);
  copy.set(bytes);
  return copy;
}

/** `count` numbers from number `first` on; halves become f32. */
export function readStoredNumbers(
  { file, at, scalar, ...stored }: StoredNumbers,
  first = 0,
  count = stored.count,
): Float32Array | Float64Array {
  const width = NUMBER_BYTES[scalar];
  const { buffer } = readRange(file, at + width * first, width * count);
  if (scalar === 'half') return Float32Array.from(new Uint16Array(buffer), fromHalf);
  return scalar === 'float' ? new Float32Array(buffer) : new Float64Array(buffer);
}

/** Numbers at a time: stored ones, or the share of the way from them to the next ones. */
export interface StoredSample {
  readonly before: StoredNumbers;
  readonly after?: StoredNumbers;
  readonly fraction: number;
}

/** Numbers at a time, linear between stored ones and in their precision, as UsdAttribute::Get has it. */
export function readSample({ before, after, fraction }: StoredSample, first = 0, count = before.count) {
  const numbers = readStoredNumbers(before, first, count);
  if (!after) return numbers;
  const next = readStoredNumbers(after, first, count);
  for (let i = 0; i < numbers.length; i++) numbers[i] = (1 - fraction) * numbers[i] + fraction * next[i];
  return numbers;
}
