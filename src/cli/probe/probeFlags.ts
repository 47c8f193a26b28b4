import type { PictureSize } from '../../scene/view/pictureViews.ts';
import type { View } from '../../scene/views/views.ts';
import type { SceneFlags } from '../flags/sceneFlags.ts';
import type { ObserverFlags } from '../flags/viewFlags.ts';

export interface ProbeFlags extends ObserverFlags, SceneFlags {
  readonly prim?: string;
  readonly pixel?: readonly [number, number];
  readonly size: PictureSize;
  readonly time?: number;
  readonly view: View;
  readonly json?: boolean;
}
