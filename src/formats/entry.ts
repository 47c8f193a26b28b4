import { extensionOf } from './files/fileSource.ts';
import { formatOf, panoramaFormat, sceneFormats } from './registry.ts';

const isShown = (path: string): boolean => !/(^|\/)(\.|__MACOSX\/)/.test(path);

/**
 * The scene files, best first: by depth, then by order of the registry (scenes before meshes they may use), then by
 * name. Hidden files are excluded.
 */
export function scenesIn(paths: readonly string[]): string[] {
  const depth = (path: string) => path.split('/').length;
  const kind = (path: string) => sceneFormats.indexOf(formatOf(path)!);
  const scenes = paths.filter((path) => kind(path) >= 0 && isShown(path));
  return scenes.sort((a, b) => depth(a) - depth(b) || kind(a) - kind(b) || (a < b ? -1 : 1));
}

/** The picture that is most likely a panorama, for files without a scene: those of radiance first, then by name. */
function panoramaIn(paths: readonly string[]): string | undefined {
  const kind = (path: string) => panoramaFormat.extensions.indexOf(extensionOf(path));
  const pictures = paths.filter((path) => kind(path) >= 0 && isShown(path));
  return pictures.sort((a, b) => kind(a) - kind(b) || (a < b ? -1 : 1))[0];
}

/**
 * The file to open: a scene, else a panorama. A single file is returned whatever its type, so that its reader reports the error.
 * @example
 * entryOf(['textures/wood.png', 'parts/wheel.usda', 'cart.usda']); // 'cart.usda'
 */
export const entryOf = (paths: readonly string[]): string | undefined =>
  paths.length === 1 ? paths[0] : (scenesIn(paths)[0] ?? panoramaIn(paths));
