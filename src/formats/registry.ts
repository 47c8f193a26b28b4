import type { Scene } from '../scene/types.ts';
import { extensionOf, type FileSource } from './files/fileSource.ts';

export type Interpolation = 'linear' | 'cubic';

/** What a user may choose when a scene is read. */
export interface ReadOptions {
  /** Name or place of the animation to show, where a file has several. Default: the first. */
  readonly animation?: string | number;
  /** Greatest distance between a resampled path and the true one, as a fraction of the object's size. */
  readonly chordTolerance?: number;
  /** USD: how things move between samples; linear is what USD says. */
  readonly interpolation?: Interpolation;
  /** Levels to which subdivision surfaces are refined, 0 … 8; 0: drawn as their polygons. Default: 2, up to 4 for meshes of few faces, or what faces there are for. */
  readonly subdivision?: number;
  /** Name of a variant set → the option to show. Default: what the file itself chooses. */
  readonly variants?: ReadonlyMap<string, string>;
  /** USD: variants by the name of a set, the best first, where nothing is chosen. */
  readonly variantFallbacks?: ReadonlyMap<string, readonly string[]>;
  /** USD: memory for samples of deforming meshes [bytes]; those of crate files that take more stay there and are read when they are needed. */
  readonly sampleMemory?: number;
  /** Told the part of a long cache that is read, and which file. */
  readonly progress?: (part: number) => void;
}

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
