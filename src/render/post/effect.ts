import type { Vec4 } from '../../shaders/types.ts';
import type { EffectContext } from './effectContext.ts';

/** A pass on the way to the result. */
export interface EffectStep {
  /** By which later steps read it. */
  readonly name: string;
  /** It makes a picture that is so many times smaller, rounded up. */
  readonly downscale: number;
  readonly color: (frame: EffectContext) => Vec4;
}

/** An effect as the GPU does it: the last step gives the result, as large as the picture. */
export type Effect = readonly [...EffectStep[], EffectStep];

export const singleStep = (color: EffectStep['color']): Effect => [{ name: 'result', downscale: 1, color }];
