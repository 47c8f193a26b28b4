import { formatOf } from '../../formats/registry.ts';
import type { Diagnostic } from '../../scene/types.ts';

const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1).toLowerCase();

/** Paths of files that a scene asked for and did not find. */
export const missingPaths = (diagnostics: readonly Diagnostic[]): string[] =>
  diagnostics.flatMap(({ missing }) => (missing ? [missing.name, ...missing.lookedFor] : []));

/**
 * Whether files that were dropped belong to the scene that is open, rather than being one: where it asked for one of them, or
 * where it could not be read and there is no scene among them.
 */
export function completes(paths: readonly string[], missing: readonly string[], isRefused: boolean): boolean {
  const wanted = new Set(missing.map(nameOf));
  return paths.some((path) => wanted.has(nameOf(path))) || (isRefused && !paths.some((path) => formatOf(path)));
}
