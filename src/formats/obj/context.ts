import { inputError } from '../fail.ts';
import type { Notes } from '../notes.ts';
import type { FileSource } from '../source.ts';

/** What every part of the reader needs to know. */
export interface ObjContext {
  readonly source: FileSource;
  /** Path of the .obj. */
  readonly entry: string;
  readonly notes: Notes;
}

/** Refuses a file: `message` tells the value on that line and what to do. */
export const lineError = (file: string, line: number, code: string, message: string): Error =>
  inputError(`obj.${code}`, `${file}: line ${line}`, message);

/** A number of a line; throws where it is none, or not finite. */
export function numberOf(file: string, line: number, word: string | undefined): number {
  const value = word ? Number(word) : Number.NaN;
  if (Number.isFinite(value)) return value;
  throw lineError(
    file,
    line,
    'number',
    word ? `${word} is not a number` : 'a number is missing; the file is cut off or damaged',
  );
}

/** The words after a line's keyword, and all of them as they stand. */
export interface Statement {
  readonly line: number;
  readonly keyword: string;
  readonly words: readonly string[];
  readonly rest: string;
}
