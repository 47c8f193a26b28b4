import type { Scene } from '../../src/scene/types.ts';

/** A scene of the gallery: its file name and the function that builds it. */
export interface ExampleScene {
  readonly name: string;
  /** The scene whose textures it shares, if it has none of its own. */
  readonly texturesOf?: string;
  /** Small, and kept as text, so that one can see what a scene is. */
  readonly readable?: boolean;
  make(): Scene;
}
