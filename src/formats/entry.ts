import { formatOf, sceneFormats } from './registry.ts';

/**
 * The scene files, best first: by depth, then by order of the registry (scenes before meshes they may use), then by
 * name. Hidden files are excluded.
 */
export function scenesIn(paths: readonly string[]): string[] {
  const depth = (path: string) => path.split('/').length;
  const kind = (path: string) => sceneFormats.indexOf(formatOf(path)!);
  const scenes = paths.filter((path) => formatOf(path) && !/(^|\/)(\.|__MACOSX\/)/.test(path));
  return scenes.sort((a, b) => depth(a) - depth(b) || kind(a) - kind(b) || (a < b ? -1 : 1));
}

/**
 * The file to open. A single file is returned whatever its type, so that its reader reports the error.
 * @example
 * entryOf(['textures/wood.png', 'parts/wheel.usda', 'cart.usda']); // 'cart.usda'
 */
export const entryOf = (paths: readonly string[]): string | undefined =>
  paths.length === 1 ? paths[0] : scenesIn(paths)[0];
