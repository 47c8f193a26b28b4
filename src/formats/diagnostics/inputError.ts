import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { InputError } from '../../scene/types.ts';
import type { DiagnosticCode } from './diagnosticCodes.ts';

/** An error with file, place, value and remedy; `code` is short and stable, for programs. */
export function inputError(code: DiagnosticCode, place: LocalizedText, message: Message, cause?: unknown): InputError {
  return new InputError({ severity: 'error', code, place, message }, { cause });
}

/** 1536 → `1.5 KiB`. */
export function formatBytes(bytes: number): LocalizedText {
  if (bytes < 1024) return msg`${bytes} bytes`;
  const units = ['KiB', 'MiB', 'GiB', 'TiB'];
  const power = Math.min(units.length, Math.floor(Math.log2(bytes) / 10));
  return `${(bytes / 1024 ** power).toPrecision(3)} ${units[power - 1]}`;
}
