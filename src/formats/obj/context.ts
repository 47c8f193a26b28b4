import type { Code } from '../codes.ts';
import { inputError } from '../fail.ts';
import type { Notes } from '../notes.ts';
import type { FileSource } from '../source.ts';
import { numberIn } from '../textLines.ts';

/** What every part of the reader needs to know. */
export interface ObjContext {
  readonly source: FileSource;
  /** Path of the .obj. */
  readonly entry: string;
  readonly notes: Notes;
}

/** Refuses a file: `message` tells the value on that line and what to do. */
export const lineError = (file: string, line: number, code: Code, message: string): Error =>
  inputError(code, `${file}: line ${line}`, message);

/** A number of a line; throws where it is none. */
export const numberOf = (file: string, line: number, word: string | undefined): number =>
  numberIn(word, (message) => lineError(file, line, 'obj.number', message));

/** The words after a line's keyword, and all of them as they stand. */
export interface Statement {
  readonly line: number;
  readonly keyword: string;
  readonly words: readonly string[];
  readonly rest: string;
}
