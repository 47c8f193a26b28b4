import { InputError } from '../../scene/types.ts';
import type { DiagnosticCode } from './diagnosticCodes.ts';

/** An error with file, place, value and remedy; `code` is short and stable, for programs. */
export function inputError(code: DiagnosticCode, place: string, message: string, cause?: unknown): InputError {
  const error = new InputError({ severity: 'error', code, place, message });
  if (cause !== undefined) error.cause = cause;
  return error;
}

/** Message of an unknown thrown value. */
export const messageOf = (thrown: unknown): string => (thrown instanceof Error ? thrown.message : String(thrown));

/** 1536 → `1.5 KiB`. */
export function formatBytes(bytes: number): string {
  if (bytes < 1024) return `${bytes} bytes`;
  const units = ['KiB', 'MiB', 'GiB', 'TiB'];
  const power = Math.min(units.length, Math.floor(Math.log2(bytes) / 10));
  return `${(bytes / 1024 ** power).toPrecision(3)} ${units[power - 1]}`;
}
