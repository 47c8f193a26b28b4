import type { SceneFlags } from '../flags/sceneFlags.ts';

export interface InspectFlags extends SceneFlags {
  readonly json?: boolean;
}
