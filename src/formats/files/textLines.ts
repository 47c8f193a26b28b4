import { inputError } from '../diagnostics/inputError.ts';

/** Bytes decoded at a time: no string is as long as a large file. */
const BLOCK = 2 ** 22;
/** Longest line [bytes]. */
export const MAX_LINE = 2 ** 24;
const NEWLINE = 10;
const RETURN = 13;

export interface TextLine {
  /** From 1. */
  readonly number: number;
  /** Without its end. */
  readonly text: string;
}

/** The lines of a text in UTF-8, ended by \n, \r\n or \r; what is not UTF-8 becomes U+FFFD. Throws an InputError at a line of more than 16 MiB. */
export function* textLines(bytes: Uint8Array, entry: string): Generator<TextLine> {
  const decoder = new TextDecoder();
  let number = 0;
  for (let from = 0; from < bytes.length; ) {
    const to = endOfBlock(bytes, from);
    if (to - from > BLOCK + MAX_LINE) {
      throw inputError(
        'text.long-line',
        `${entry}: after line ${number}`,
        `a line has more than ${MAX_LINE} bytes; the file is damaged`,
      );
    }
    const lines = decoder.decode(bytes.subarray(from, to)).split(/\r\n|\n|\r/);
    // After the last line's end nothing stands.
    if (lines.at(-1) === '') lines.pop();
    for (const text of lines) yield { number: ++number, text };
    from = to;
  }
}

/** The end of the first line that ends after a block's bytes; the end of the file where none does. */
function endOfBlock(bytes: Uint8Array, from: number): number {
  const isEnd = (at: number): boolean => bytes[at] === NEWLINE || (bytes[at] === RETURN && bytes[at + 1] !== NEWLINE);
  let at = Math.min(from + BLOCK, bytes.length);
  while (at < bytes.length && at - from <= BLOCK + MAX_LINE && !isEnd(at - 1)) at++;
  return at;
}

/** The number that a word is, as single precision has room for it; throws what `fail` makes of the reason where it is none. */
export function parseFiniteNumber(word: string | undefined, fail: (message: string) => Error): number {
  if (!word) throw fail('a number is missing; the file is cut off or damaged');
  const value = Number(word);
  if (Number.isFinite(Math.fround(value))) return value;
  throw fail(Number.isFinite(value) ? `${word} is too large a number` : `${word.slice(0, 40)} is not a number`);
}
