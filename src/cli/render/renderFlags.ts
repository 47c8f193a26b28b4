import type { FrameSpacing } from '../../flight/spacing.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { FalseColorOptions } from '../../nodes/pictures/falseColor.ts';
import type { AovName } from '../../scene/view/view.ts';
import type { FrameRange } from '../flags/parse.ts';
import type { PipelineFlags } from '../flags/pipelineFlags.ts';
import type { SceneFlags } from '../flags/sceneFlags.ts';
import type { ObserverFlags, SettingFlags } from '../flags/viewFlags.ts';

export interface RenderFlags extends SceneFlags, ObserverFlags, SettingFlags, PipelineFlags, FalseColorOptions {
  readonly output: string;
  readonly time?: number;
  readonly frames?: FrameRange;
  readonly fps?: number;
  readonly spacing?: FrameSpacing;
  readonly stayInPlace?: boolean;
  readonly vantage?: Vec3;
  /** File of a flight to film. */
  readonly flight?: string;
  readonly aov?: readonly AovName[];
  readonly samples?: number;
  readonly json?: boolean;
  /** For projects: `node.param=value`. */
  readonly set?: readonly string[];
}

export interface ProjectFilesFlags extends Omit<RenderFlags, 'output'> {
  readonly folder?: string;
}
