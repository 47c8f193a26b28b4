import { formatOf, sceneFormats } from './registry.ts';

/**
 * The scenes among files, the best first: the least deep, then of the kind that comes first in the registry (a scene rather
 * than a mesh that it may use), then by name. Hidden files are none.
 */
export function scenesIn(paths: readonly string[]): string[] {
  const depth = (path: string) => path.split('/').length;
  const kind = (path: string) => sceneFormats.indexOf(formatOf(path)!);
  const scenes = paths.filter((path) => formatOf(path) && !/(^|\/)(\.|__MACOSX\/)/.test(path));
  return scenes.sort((a, b) => depth(a) - depth(b) || kind(a) - kind(b) || (a < b ? -1 : 1));
}

/** Which of the files is the scene. A single file is taken whatever it is, so that its reader can say what is wrong. */
export const entryOf = (paths: readonly string[]): string | undefined =>
  paths.length === 1 ? paths[0] : scenesIn(paths)[0];
