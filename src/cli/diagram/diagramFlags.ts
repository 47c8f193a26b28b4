import type { ColorScheme } from '../../diagrams/lineStyle.ts';
import type { DiagramKind } from '../../diagrams/sceneDiagram.ts';
import type { DiagramFrame } from '../../diagrams/spacetimeDiagram.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { SceneOrProjectFlags } from '../flags/sceneOrProjectFlags.ts';

export interface DiagramFlags extends SceneOrProjectFlags {
  readonly output: string;
  readonly of: DiagramKind;
  readonly prim?: readonly string[];
  readonly time?: number;
  readonly frame: DiagramFrame;
  readonly axis?: Vec3;
  readonly secondAxis?: Vec3;
  readonly span?: number;
  readonly theme: ColorScheme;
  readonly size: PictureSize;
}
