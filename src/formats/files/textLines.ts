import { type Message, msg } from '../../messages/message.ts';
import { inputError } from '../diagnostics/inputError.ts';

/** Bytes decoded at once: a large file exceeds the maximum string length. */
const BLOCK = 2 ** 22;
/** Longest line [bytes]. */
export const MAX_LINE = 2 ** 24;
const NEWLINE = 10;
const RETURN = 13;

export interface TextLine {
  /** From 1. */
  readonly number: number;
  /** Without line ending. */
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
        msg`${entry}: after line ${number}`,
        msg`a line has more than ${MAX_LINE} bytes; the file is damaged`,
      );
    }
    const lines = decoder.decode(bytes.subarray(from, to)).split(/\r\n|\n|\r/);
    // The last line ending is followed by nothing.
    if (lines.at(-1) === '') lines.pop();
    for (const text of lines) yield { number: ++number, text };
    from = to;
  }
}

/** End of the first line that ends after the block; end of the file if none does. */
function endOfBlock(bytes: Uint8Array, from: number): number {
  const isEnd = (at: number): boolean => bytes[at] === NEWLINE || (bytes[at] === RETURN && bytes[at + 1] !== NEWLINE);
  let at = Math.min(from + BLOCK, bytes.length);
  while (at < bytes.length && at - from <= BLOCK + MAX_LINE && !isEnd(at - 1)) at++;
  return at;
}

/** Parses a number in the range of f32; throws what `fail` returns for the reason otherwise. */
export function parseFiniteNumber(word: string | undefined, fail: (message: Message) => Error): number {
  if (!word) throw fail(msg`a number is missing; the file is cut off or damaged`);
  const value = Number(word);
  if (Number.isFinite(Math.fround(value))) return value;
  throw fail(Number.isFinite(value) ? msg`${word} is too large a number` : msg`${word.slice(0, 40)} is not a number`);
}
