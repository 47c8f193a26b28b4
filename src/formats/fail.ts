import { InputError } from '../scene/types.ts';
import type { Code } from './codes.ts';

/** An error that names file, place and value and says what to do; `code` is short and stable, for programs. */
export function inputError(code: Code, place: string, message: string, cause?: unknown): InputError {
  const error = new InputError({ severity: 'error', code, place, message });
  if (cause !== undefined) error.cause = cause;
  return error;
}

/** What an unknown thrown value says. */
export const messageOf = (thrown: unknown): string => (thrown instanceof Error ? thrown.message : String(thrown));

/** 1536 → `1.5 KiB`. */
export function formatBytes(bytes: number): string {
  const units = ['bytes', 'KiB', 'MiB', 'GiB', 'TiB'];
  const power = Math.min(units.length - 1, bytes < 1024 ? 0 : Math.floor(Math.log2(bytes) / 10));
  const value = bytes / 1024 ** power;
  return `${power === 0 ? value : value.toPrecision(3)} ${units[power]}`;
}
