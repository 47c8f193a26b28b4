import { fromHalf } from '../../math/half.ts';

/**
 * A file whose byte ranges can be read at any time; plain data, so that it can be sent to other threads. `handle` is interpreted by the host's reader: a path on
 * disk, a `File` of the page, or bytes in memory.
 */
export interface StoredFile {
  /** For messages. */
  readonly name: string;
  /** Interpreted by the host's reader. */
  readonly handle: unknown;
}

/** An array of numbers in a file, little-endian. */
export interface StoredNumbers {
  readonly file: StoredFile;
  /** Byte offset. */
  readonly at: number;
  readonly count: number;
  readonly scalar: 'half' | 'float' | 'double';
}

/** Reads `length` bytes of a file from offset `at` into a new buffer. Throws an InputError if the file no longer has them. */
export type ReadRange = (file: StoredFile, at: number, length: number) => Uint8Array<ArrayBuffer>;

const NUMBER_BYTES = { half: 2, float: 4, double: 8 } as const;

export const storedByteLength = ({ count, scalar }: Pick<StoredNumbers, 'count' | 'scalar'>): number =>
  count * NUMBER_BYTES[scalar];

let hostReader: ReadRange | undefined;

/** Sets how this thread reads files that are not in memory; called once when a thread starts. */
export function setFileReader(read: ReadRange): void {
  hostReader = read;
}

export function readRange(file: StoredFile, at: number, length: number): Uint8Array<ArrayBuffer> {
  const { handle } = file;
  if (handle instanceof Uint8Array) return copyOf(handle.subarray(at, at + length));
  if (!hostReader) throw new Error(`this thread was not told how to read ${file.name}`);
  return hostReader(file, at, length);
}

/** Unlike `slice`, also copies Buffers of Node. */
function copyOf(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const copy = new Uint8Array(bytes.length);
  copy.set(bytes);
  return copy;
}

/** Reads `count` numbers from index `first` on; halves become f32. */
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

/** Numbers at a time: stored ones, or interpolated to the next ones by `fraction`. */
export interface StoredSample {
  readonly before: StoredNumbers;
  readonly after?: StoredNumbers;
  readonly fraction: number;
}

/** Interpolates linearly in the precision of the stored numbers, as UsdAttribute::Get. */
export function readSample({ before, after, fraction }: StoredSample, first = 0, count = before.count) {
  const numbers = readStoredNumbers(before, first, count);
  if (!after) return numbers;
  const next = readStoredNumbers(after, first, count);
  for (let i = 0; i < numbers.length; i++) numbers[i] = (1 - fraction) * numbers[i] + fraction * next[i];
  return numbers;
}
