import type { SettingName } from '../../scene/settings/settings.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { SceneFlags } from '../flags/sceneFlags.ts';
import type { ObserverFlags, SettingFlags } from '../flags/viewFlags.ts';

/** The settings that change what is probed. */
export const PROBE_SETTINGS = [
  'view',
  'coneSlope',
  'solver',
  'iterations',
  'damping',
] as const satisfies readonly SettingName[];

export interface ProbeFlags extends ObserverFlags, SceneFlags, Pick<SettingFlags, (typeof PROBE_SETTINGS)[number]> {
  readonly prim?: string;
  readonly pixel?: readonly [number, number];
  readonly size: PictureSize;
  readonly time?: number;
  readonly json?: boolean;
}
