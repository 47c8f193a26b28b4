import type { Scene } from '../../src/scene/types.ts';

/** One scene of the gallery: a file name, and how it is made. */
export interface ExampleScene {
  readonly name: string;
  /** The scene whose pictures it shares, where it has none of its own. */
  readonly texturesOf?: string;
  make(): Scene;
}
