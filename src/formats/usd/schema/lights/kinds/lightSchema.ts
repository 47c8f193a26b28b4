import type { PrimSpec } from '../../../layer/layer.ts';
import type { StageContext } from '../../context.ts';
import type { TextureLoader } from '../../materials/textureLoader.ts';
import type { SlowlightAttributes } from '../../slowlightAttributes.ts';
import type { StageTransform } from '../../transforms/stageTransform.ts';

/** A light prim with the context for its reader. */
export interface LightPrim {
  readonly context: StageContext;
  readonly textures: TextureLoader;
  readonly prim: PrimSpec;
  readonly frame: StageTransform;
  readonly slowlight: SlowlightAttributes;
}

/** Reader of a UsdLux schema (docs/adr/0024-light-kinds.md). */
export interface LightSchema<L> {
  readonly typeNames: readonly string[];
  /** Recognized by an attribute, for types that several kinds share. */
  isAsked?(prim: PrimSpec): boolean;
  /** Whether its motion is read; otherwise it is fixed at the stage's start. */
  readonly moves: boolean;
  read(prim: LightPrim): Promise<L>;
}
