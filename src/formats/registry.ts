import type { Scene } from '../scene/types.ts';
import { extensionOf, type FileSource } from './files/fileSource.ts';
import type { ReadOptions } from './readOptions.ts';

/** A kind of scene file. `read` loads its parser on first use, so that the page stays small. */
export interface SceneFormat {
  readonly id: string;
  /** As it is called in menus and messages. */
  readonly name: string;
  /** Lower case, without the dot. */
  readonly extensions: readonly string[];
  read(source: FileSource, entry: string, options: ReadOptions): Promise<Scene>;
}

/** Every kind of scene file that can be opened; those that may use others come before them. */
export const sceneFormats: readonly SceneFormat[] = [
  {
    id: 'usd',
    name: 'OpenUSD',
    extensions: ['usd', 'usda', 'usdc', 'usdz'],
    read: async (source, entry, options) => (await import('./usd/index.ts')).readUsd(source, entry, options),
  },
  {
    id: 'gltf',
    name: 'glTF',
    extensions: ['gltf', 'glb'],
    read: async (source, entry, options) => (await import('./gltf/index.ts')).readGltf(source, entry, options),
  },
  {
    id: 'obj',
    name: 'Wavefront OBJ',
    extensions: ['obj'],
    read: async (source, entry) => (await import('./obj/index.ts')).readObj(source, entry),
  },
  {
    id: 'ply',
    name: 'PLY',
    extensions: ['ply'],
    read: async (source, entry) => (await import('./ply/index.ts')).readPly(source, entry),
  },
  {
    id: 'stl',
    name: 'STL',
    extensions: ['stl'],
    read: async (source, entry) => (await import('./stl/index.ts')).readStl(source, entry),
  },
];

/** The format of a path by its extension; undefined where none reads it. */
export function formatOf(path: string): SceneFormat | undefined {
  const extension = extensionOf(path);
  return sceneFormats.find((format) => format.extensions.includes(extension));
}
