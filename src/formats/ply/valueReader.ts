import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { formatBytes, inputError } from '../diagnostics/inputError.ts';
import { parseFiniteNumber, textLines } from '../files/textLines.ts';
import type { Element, PlyHeader, ScalarType } from './header.ts';
import { SIZES } from './header.ts';

/** Reads the values of a PLY sequentially. */
export interface PlyValueReader {
  /** The next value; throws an InputError where there is none. */
  next(type: ScalarType): number;
  /** Ends a row; in a text with a row on each line, what its line has beyond the declared values is left out. */
  endRow(): void;
  /** Values left out so far. */
  readonly extraValues: number;
  /** Location of the last value, for messages: `line 12`, `byte 3400`. */
  place(): Message;
  /** Throws an InputError that names `what` where the rest of the file is too short for `rows` rows of these types. */
  expect(what: () => Message, rows: number, types: readonly ScalarType[]): void;
}

export const plyValueReader = (bytes: Uint8Array, header: PlyHeader, entry: string): PlyValueReader =>
  header.format === 'ascii' ? new PlyTextReader(bytes, header, entry) : new PlyBinaryReader(bytes, header, entry);

/** Types of the values that each row has at least: of a list its length. */
export const minRowTypes = ({ properties }: Element): ScalarType[] =>
  properties.map(({ type, count }) => count ?? type);

function tooShort(place: LocalizedText, what: Message, wanted: number, left: number): Error {
  const message = msg`${what} take ${formatBytes(wanted)} at the least, but ${formatBytes(left)} are left: the file is cut off or damaged; copy it again`;
  return inputError('ply.truncated', place, message);
}

class PlyBinaryReader implements PlyValueReader {
  readonly extraValues = 0;
  private readonly view: DataView;
  private readonly entry: string;
  private readonly little: boolean;
  private at: number;
  private last: number;
  constructor(bytes: Uint8Array, { end, format }: PlyHeader, entry: string) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.entry = entry;
    this.little = format === 'binary_little_endian';
    this.at = end;
    this.last = end;
  }

  place(): Message {
    return msg`byte ${this.last}`;
  }

  endRow(): void {}

  expect(what: () => Message, rows: number, types: readonly ScalarType[]): void {
    const wanted = rows * types.reduce((sum, type) => sum + SIZES[type], 0);
    const left = this.view.byteLength - this.at;
    if (wanted > left) throw tooShort(msg`${this.entry}: byte ${this.at}`, what(), wanted, left);
  }

  next(type: ScalarType): number {
    const at = this.at;
    if (at + SIZES[type] > this.view.byteLength) {
      throw tooShort(msg`${this.entry}: byte ${at}`, msg`the next value`, SIZES[type], this.view.byteLength - at);
    }
    this.last = at;
    this.at = at + SIZES[type];
    switch (type) {
      case 'int8':
        return this.view.getInt8(at);
      case 'uint8':
        return this.view.getUint8(at);
      case 'int16':
        return this.view.getInt16(at, this.little);
      case 'uint16':
        return this.view.getUint16(at, this.little);
      case 'int32':
        return this.view.getInt32(at, this.little);
      case 'uint32':
        return this.view.getUint32(at, this.little);
      case 'float32':
        return this.view.getFloat32(at, this.little);
      default:
        return this.view.getFloat64(at, this.little);
    }
  }
}

const NEWLINE = 10;
const RETURN = 13;
const LAST_SPACE = 32;

/** Number of lines that are not blank. */
function filledLines(bytes: Uint8Array): number {
  let [count, isFilled] = [0, false];
  for (const byte of bytes) {
    if (byte === NEWLINE || byte === RETURN) isFilled = false;
    else if (byte > LAST_SPACE && !isFilled) {
      isFilled = true;
      count++;
    }
  }
  return count;
}

/** Whitespace-separated values; line breaks are not significant, unless there are as many lines as rows. */
class PlyTextReader implements PlyValueReader {
  extraValues = 0;
  private readonly entry: string;
  private readonly lines: Iterator<{ number: number; text: string }>;
  private readonly bytes: number;
  private readonly firstLine: number;
  private readonly isRowALine: boolean;
  private words: string[] = [];
  private word = 0;
  private line: number;
  constructor(bytes: Uint8Array, { elements, end, endLine }: PlyHeader, entry: string) {
    this.entry = entry;
    const rows = elements.reduce((sum, { rows, properties }) => sum + (properties.length > 0 ? rows : 0), 0);
    this.isRowALine = filledLines(bytes.subarray(end)) === rows;
    this.lines = textLines(bytes.subarray(end), entry);
    this.bytes = bytes.length - end;
    this.firstLine = endLine;
    this.line = endLine;
  }

  place(): Message {
    return msg`line ${this.line}`;
  }

  endRow(): void {
    if (!this.isRowALine) return;
    this.extraValues += this.words.length - this.word;
    this.word = this.words.length;
  }

  /** A value takes at least two characters: only counts beyond the whole file's size are detected. */
  expect(what: () => Message, rows: number, types: readonly ScalarType[]): void {
    const wanted = 2 * rows * types.length - 1;
    if (wanted > this.bytes) throw tooShort(msg`${this.entry}: ${this.place()}`, what(), wanted, this.bytes);
  }

  next(): number {
    while (this.word >= this.words.length) {
      const { value, done } = this.lines.next();
      if (done) throw this.error(msg`a number is missing at the end; the file is cut off, copy it again`);
      this.line = this.firstLine + value.number;
      const text = value.text.trim();
      this.words = text === '' ? [] : text.split(/\s+/);
      this.word = 0;
    }
    return parseFiniteNumber(this.words[this.word++], (message) => this.error(message));
  }

  private error(message: Message): Error {
    return inputError('ply.number', msg`${this.entry}: ${this.place()}`, message);
  }
}
