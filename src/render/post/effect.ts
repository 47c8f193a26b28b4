import type { Vec4 } from '../../shaders/types.ts';
import type { EffectContext } from './effectContext.ts';

/** One pass of an effect. */
export interface EffectStep {
  /** Name by which later steps read its image. */
  readonly name: string;
  /** Its image is this many times smaller than the picture, rounded up. */
  readonly downscale: number;
  readonly color: (frame: EffectContext) => Vec4;
}

/** An effect's passes on the GPU; the last step makes the result, at full size. */
export type Effect = readonly [...EffectStep[], EffectStep];

export const singleStep = (color: EffectStep['color']): Effect => [{ name: 'result', downscale: 1, color }];
