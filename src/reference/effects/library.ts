import type { EffectChannel, EffectId } from '../../scene/effects.ts';
import type { AovName } from '../../scene/view.ts';
import { bilateralFilter } from './bilateralFilter.ts';
import { bloom } from './bloom.ts';
import { depthOfField } from './depthOfField.ts';
import { edge } from './edge.ts';
import { fog } from './fog.ts';
import { Frame, type Plane, type Taken } from './frame.ts';
import { gaussianBlur } from './gaussianBlur.ts';
import { mixed } from './mix.ts';
import { sharpen } from './sharpen.ts';
import { skyBackground } from './skyBackground.ts';
import { vignette } from './vignette.ts';

type Effect = (frame: Frame, args: readonly number[]) => Plane;

const EFFECTS_OF: Readonly<Record<EffectId, Effect>> = {
  'gaussian-blur': gaussianBlur,
  'bilateral-filter': bilateralFilter,
  'sky-background': skyBackground,
  sharpen,
  bloom,
  edge,
  vignette,
  fog,
  'depth-of-field': depthOfField,
};

/** The data that a picture is to be taken with, by what an effect reads. */
export const AOVS_READ: Readonly<Record<EffectChannel, readonly AovName[]>> = {
  depth: ['object', 'depth'],
  normal: ['object', 'normal'],
  event: ['object', 'position'],
  direction: [],
};

/** A picture after an effect, in f64; where the mask (its first channel) is 0 it stays as it was. */
export function applied(id: EffectId, args: readonly number[], taken: Taken, mask?: Plane): Plane {
  const after = EFFECTS_OF[id](new Frame(taken), args);
  return mask ? mixed('normal', 1, taken.image, after, mask) : after;
}
