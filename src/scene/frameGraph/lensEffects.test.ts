import { expect, it } from 'vitest';
import { MessageError } from '../../messages/messageError.ts';
import { perspective } from '../view/lenses/perspectiveLens.ts';
import type { EffectId } from './effects.ts';
import type { FrameGraph } from './frameGraph.ts';
import { assertLensEffects } from './lensEffects.ts';

const withEffect = (effect: EffectId): FrameGraph => ({
  extraBuffers: [],
  passes: [
    { kind: 'light', buffer: 0, shadows: true, occlusion: true },
    { kind: 'effect', effect, args: [], image: 0, buffer: 0 },
  ],
});
const AROUND = { kind: 'equirectangular' } as const;

it('effects that have an axis are of perspective lenses, the others of all', () => {
  for (const effect of ['depth-of-field', 'vignette'] as const) {
    expect(() => assertLensEffects(AROUND, withEffect(effect))).toThrow(MessageError);
    expect(() => assertLensEffects(perspective(1), withEffect(effect))).not.toThrow();
  }
  for (const effect of ['bloom', 'fog', 'sky-background'] as const)
    expect(() => assertLensEffects(AROUND, withEffect(effect))).not.toThrow();
});
