import { scenesIn } from '../../formats/entry.ts';
import type { Diagnostic } from '../../scene/types.ts';

const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1).toLowerCase();

/** Paths of files that a scene asked for and did not find. */
export const missingPaths = (diagnostics: readonly Diagnostic[]): string[] =>
  diagnostics.flatMap(({ missing }) => (missing ? [missing.name, ...missing.lookedFor] : []));

export interface OpenScene {
  /** By which it was opened. */
  readonly name: string;
  readonly missing: readonly string[];
  /** It could not be read. */
  readonly isRefused: boolean;
}

/**
 * Whether files that were dropped belong to the scene that is open, rather than being one: where it asked for one of them, or
 * could not be read, and where there is no other scene among them.
 */
export function completes(paths: readonly string[], { name, missing, isRefused }: OpenScene): boolean {
  const wanted = new Set(missing.map(nameOf));
  const isOther = (scene: string): boolean => !wanted.has(nameOf(scene)) && nameOf(scene) !== nameOf(name);
  if (scenesIn(paths).some(isOther)) return false;
  return isRefused || paths.some((path) => wanted.has(nameOf(path)));
}
