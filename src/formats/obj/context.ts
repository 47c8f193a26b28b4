import type { DiagnosticCode } from '../diagnostics/diagnosticCodes.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import type { FileSource } from '../files/fileSource.ts';
import { parseFiniteNumber } from '../files/textLines.ts';

/** What every part of the reader needs to know. */
export interface ObjContext {
  readonly source: FileSource;
  /** Path of the .obj. */
  readonly entry: string;
  readonly notes: DiagnosticLog;
}

/** Refuses a file: `message` tells the value on that line and what to do. */
export const lineError = (file: string, line: number, code: DiagnosticCode, message: string): Error =>
  inputError(code, `${file}: line ${line}`, message);

/** A number of a line; throws where it is none. */
export const numberOf = (file: string, line: number, word: string | undefined): number =>
  parseFiniteNumber(word, (message) => lineError(file, line, 'obj.number', message));

/** The words after a line's keyword, and all of them as they stand. */
export interface ObjStatement {
  readonly line: number;
  readonly keyword: string;
  readonly words: readonly string[];
  readonly rest: string;
}
