import { type Message, msg } from '../../messages/message.ts';
import type { DiagnosticCode } from '../diagnostics/diagnosticCodes.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import type { FileSource } from '../files/fileSource.ts';
import { parseFiniteNumber } from '../files/textLines.ts';

export interface ObjContext {
  readonly source: FileSource;
  /** Path of the .obj. */
  readonly entry: string;
  readonly notes: DiagnosticLog;
}

/** An InputError at a line; `message` names the value and a remedy. */
export const lineError = (file: string, line: number, code: DiagnosticCode, message: Message): Error =>
  inputError(code, msg`${file}: line ${line}`, message);

/** Parses a number; throws an InputError at the line if it is not one. */
export const numberOf = (file: string, line: number, word: string | undefined): number =>
  parseFiniteNumber(word, (message) => lineError(file, line, 'obj.number', message));

/** The words after a line's keyword, and the unsplit rest of the line. */
export interface ObjStatement {
  readonly line: number;
  readonly keyword: string;
  readonly words: readonly string[];
  readonly rest: string;
}
