import type { Scene } from '../../src/scene/types.ts';

/** One scene of the gallery: a file name, and how it is made. */
export interface ExampleScene {
  readonly name: string;
  make(): Scene;
}
