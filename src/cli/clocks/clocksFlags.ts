import type { SceneOrProjectFlags } from '../flags/sceneOrProjectFlags.ts';

export interface ClocksFlags extends SceneOrProjectFlags {
  readonly prim?: readonly string[];
  readonly time?: number;
  /** File of a recorded flight, whose pilot is the observer. */
  readonly flight?: string;
  readonly json?: boolean;
}
