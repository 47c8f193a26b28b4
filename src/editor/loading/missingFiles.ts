import { scenesIn } from '../../formats/entry.ts';
import { formatOf, panoramaFormat } from '../../formats/registry.ts';
import type { Diagnostic } from '../../scene/types.ts';

const baseName = (path: string): string => path.slice(path.lastIndexOf('/') + 1).toLowerCase();

/** Paths of files that a scene references and that were not found. */
export const missingPaths = (diagnostics: readonly Diagnostic[]): string[] =>
  diagnostics.flatMap(({ missing }) => (missing ? [missing.name, ...missing.lookedFor] : []));

export interface OpenSceneStatus {
  /** Name under which it was opened. */
  readonly name: string;
  readonly missing: readonly string[];
  /** Whether it could not be read. */
  readonly failed: boolean;
}

/**
 * Whether dropped files belong to the open scene rather than being a new one: it lacks one of them, or could not be
 * read, and there is no other scene among them.
 */
export function suppliesMissingFiles(paths: readonly string[], { name, missing, failed }: OpenSceneStatus): boolean {
  const wanted = new Set(missing.map(baseName));
  const isOther = (scene: string): boolean => !wanted.has(baseName(scene)) && baseName(scene) !== baseName(name);
  if (scenesIn(paths).some(isOther)) return false;
  // What is a picture itself lacks no others, unless they are its other faces, which are opened with it.
  return (failed && formatOf(name) !== panoramaFormat) || paths.some((path) => wanted.has(baseName(path)));
}
