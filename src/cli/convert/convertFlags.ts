import type { SceneFlags } from '../flags/sceneFlags.ts';

export interface ConvertFlags extends SceneFlags {
  readonly json?: boolean;
}
