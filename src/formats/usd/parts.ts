import type { Frame } from './frame.ts';
import type { PrimSpec } from './layer.ts';
import type { MeshLight } from './meshLights.ts';
import type { Shape } from './shape.ts';
import type { Directions } from './slowlight.ts';

/** Something to see that is not yet in its place. */
export interface Part {
  readonly path: string;
  readonly shape: Shape;
  readonly frame: Frame;
  readonly directions: Directions;
  /** The material, by its place in the scene's, that an instance's own displayColor changes. */
  readonly colorable: number | undefined;
  /** Absent where it does not shine. */
  readonly light?: MeshLight;
}

/** An instancer, and where it is. */
export interface Site {
  readonly prim: PrimSpec;
  readonly frame: Frame;
  readonly directions: Directions;
}

/** What is at a prim and below it. */
export interface Subtree {
  /** Of the prim that the paths of what is in it begin with: the parent of its root. */
  readonly parentPath: string;
  readonly parts: readonly Part[];
  readonly instancers: readonly Site[];
}
