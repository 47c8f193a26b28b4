import type { Scene } from '../scene/types.ts';
import { extensionOf, type FileSource } from './files/fileSource.ts';
import { FILM_EXTENSIONS } from './film/filmExtensions.ts';
import type { ReadOptions } from './readOptions.ts';

/** A scene file format. `read` loads its parser lazily, to keep the page small. */
export interface SceneFormat {
  /** Short and stable, for programs. */
  readonly id: string;
  /** Display name. */
  readonly name: string;
  /** In lists of formats: `USD`. */
  readonly shortName: string;
  /** Lower case, without the dot. */
  readonly extensions: readonly string[];
  /** Reads the file `entry` of `source`. Throws an InputError. */
  read(source: FileSource, entry: string, options: ReadOptions): Promise<Scene>;
}

/**
 * All readable scene formats; those that can reference others come first.
 * @example
 * sceneFormats.flatMap(({ extensions }) => extensions).includes('usdz'); // true
 */
export const sceneFormats: readonly SceneFormat[] = [
  {
    id: 'usd',
    name: 'OpenUSD',
    shortName: 'USD',
    extensions: ['usd', 'usda', 'usdc', 'usdz'],
    read: async (source, entry, options) => (await import('./usd/index.ts')).readUsd(source, entry, options),
  },
  {
    id: 'gltf',
    name: 'glTF',
    shortName: 'glTF',
    extensions: ['gltf', 'glb'],
    read: async (source, entry, options) => (await import('./gltf/index.ts')).readGltf(source, entry, options),
  },
  {
    id: 'obj',
    name: 'Wavefront OBJ',
    shortName: 'OBJ',
    extensions: ['obj'],
    read: async (source, entry) => (await import('./obj/index.ts')).readObj(source, entry),
  },
  {
    id: 'ply',
    name: 'PLY',
    shortName: 'PLY',
    extensions: ['ply'],
    read: async (source, entry) => (await import('./ply/index.ts')).readPly(source, entry),
  },
  {
    id: 'stl',
    name: 'STL',
    shortName: 'STL',
    extensions: ['stl'],
    read: async (source, entry) => (await import('./stl/index.ts')).readStl(source, entry),
  },
];

/**
 * Pictures and films of all directions, which are scenes too. Not one of `sceneFormats`, since most pictures among files are textures of a scene beside them.
 * @example
 * panoramaFormat.extensions.includes('hdr'); // true
 */
export const panoramaFormat: SceneFormat = {
  id: 'panorama',
  name: 'Panorama',
  shortName: 'panorama',
  extensions: ['hdr', 'exr', 'png', 'jpg', 'jpeg', 'webp', 'avif', ...FILM_EXTENSIONS],
  read: async (source, entry, options) => (await import('./panorama/index.ts')).readPanorama(source, entry, options),
};

/**
 * The format by a path's extension; undefined if unsupported.
 * @example
 * formatOf('models/Chair.GLB')!.id; // 'gltf'
 * formatOf('notes.txt'); // undefined
 */
export function formatOf(path: string): SceneFormat | undefined {
  const extension = extensionOf(path);
  return [...sceneFormats, panoramaFormat].find(({ extensions }) => extensions.includes(extension));
}
