import type { PrimSpec } from '../../../layer/layer.ts';
import type { StageContext } from '../../context.ts';
import type { TextureLoader } from '../../materials/textureLoader.ts';
import type { SlowlightAttributes } from '../../slowlightAttributes.ts';
import type { StageTransform } from '../../transforms/stageTransform.ts';

/** A prim that is a light, and what its reader needs. */
export interface LightPrim {
  readonly context: StageContext;
  readonly textures: TextureLoader;
  readonly prim: PrimSpec;
  readonly frame: StageTransform;
  readonly slowlight: SlowlightAttributes;
}

/** How prims of a schema of UsdLux become lights of a kind (docs/adr/0024-light-kinds.md). */
export interface LightSchema<L> {
  readonly typeNames: readonly string[];
  /** Told by an attribute from other lights of its type. */
  isAsked?(prim: PrimSpec): boolean;
  /** Whether its motion is kept: it is held at the stage's start otherwise. */
  readonly moves: boolean;
  read(prim: LightPrim): Promise<L>;
}
