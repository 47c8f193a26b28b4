import type { Scene } from '../scene/types.ts';
import { extensionOf, type FileSource } from './source.ts';

/** What a user may choose when a scene is read. */
export interface ReadOptions {
  /** Name or place of the animation to show, where a file has several. Default: the first. */
  readonly animation?: string | number;
  /** Greatest distance between a resampled path and the true one, as a fraction of the object's size. */
  readonly chordTolerance?: number;
  /** Variants to show instead of those that the file selects; of which there are, the scene tells. */
  readonly variants?: readonly VariantChoice[];
  /** Variants by set, the best first, where nothing is selected. */
  readonly variantFallbacks?: Readonly<Record<string, readonly string[]>>;
}

/** One choice among a `VariantSet`; an empty variant shows none. */
export interface VariantChoice {
  /** Of the prim that has the set. */
  readonly path: string;
  readonly set: string;
  readonly variant: string;
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

/** Every kind of scene file that can be opened. */
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
];

/** The format of a path by its extension; undefined where none reads it. */
export function formatOf(path: string): SceneFormat | undefined {
  const extension = extensionOf(path);
  return sceneFormats.find((format) => format.extensions.includes(extension));
}
