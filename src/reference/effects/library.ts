import { argumentsOf, type EffectChannel, type EffectId } from '../../scene/effects.ts';
import type { Channel, Program } from '../../scene/shaderText/program.ts';
import type { AovName } from '../../scene/view.ts';
import { antialiasing } from './antialiasing.ts';
import { bilateralFilter } from './bilateralFilter.ts';
import { bloom } from './bloom.ts';
import { depthOfField } from './depthOfField.ts';
import { edge } from './edge.ts';
import { fog } from './fog.ts';
import { Frame, type Plane, type Taken } from './frame.ts';
import { gaussianBlur } from './gaussianBlur.ts';
import { mixed } from './mix.ts';
import { written } from './shaderText.ts';
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
  antialiasing,
};

/** The data that a picture is to be taken with, by what an effect reads. */
export const AOVS_READ: Readonly<Record<EffectChannel, readonly AovName[]>> = {
  depth: ['object', 'depth'],
  normal: ['object', 'normal'],
  event: ['object', 'position'],
  direction: [],
};

/** The same, by what a text looks at. */
export const AOVS_LOOKED_AT: Readonly<Record<Channel, readonly AovName[]>> = {
  image: [],
  there: ['object'],
  depth: AOVS_READ.depth,
  normal: AOVS_READ.normal,
  event: AOVS_READ.event,
  emissionTime: ['object', 'emission_time'],
  velocity: ['object', 'velocity'],
  doppler: ['object', 'doppler'],
  object: ['object'],
};

/** A picture after an effect, in f64; where the mask (its first channel) is 0 it stays as it was. */
export function applied(of: EffectId | Program, args: readonly number[], taken: Taken, mask?: Plane): Plane {
  const frame = new Frame(taken);
  const after =
    typeof of === 'string' ? EFFECTS_OF[of](frame, argumentsOf(of, args)) : written(of, frame, args, taken.view.t);
  return mask ? mixed('normal', 1, taken.image, after, mask) : after;
}
