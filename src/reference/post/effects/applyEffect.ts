import { clampEffectArguments, type EffectChannel, type EffectId } from '../../../scene/frameGraph/effects.ts';
import type { ShaderChannel, ShaderProgram } from '../../../scene/shaderText/program.ts';
import type { AovName } from '../../../scene/view/view.ts';
import { antialiasing } from './antialiasing.ts';
import { bilateralFilter } from './bilateralFilter.ts';
import { bloom } from './bloom.ts';
import { depthOfField } from './depthOfField.ts';
import { edge } from './edge.ts';
import { type EffectInput, type FloatImage, GBufferReader } from './effectInput.ts';
import { fog } from './fog.ts';
import { gaussianBlur } from './gaussianBlur.ts';
import { hueShift } from './hueShift.ts';
import { lensGrid } from './lensGrid.ts';
import { mixImages } from './mix.ts';
import { observerMarks } from './observerMarks.ts';
import { applyShaderText } from './shaderText.ts';
import { sharpen } from './sharpen.ts';
import { skyBackground } from './skyBackground.ts';
import { vignette } from './vignette.ts';

type EffectFunction = (frame: GBufferReader, args: readonly number[]) => FloatImage;

const EFFECT_FUNCTIONS: Readonly<Record<EffectId, EffectFunction>> = {
  'gaussian-blur': gaussianBlur,
  'bilateral-filter': bilateralFilter,
  'sky-background': skyBackground,
  sharpen,
  bloom,
  edge,
  vignette,
  fog,
  'hue-shift': hueShift,
  'observer-marks': observerMarks,
  'lens-grid': lensGrid,
  'depth-of-field': depthOfField,
  antialiasing,
};

/** The AOVs to render for each channel that an effect reads. */
export const AOVS_OF_EFFECT_CHANNEL: Readonly<Record<EffectChannel, readonly AovName[]>> = {
  depth: ['object', 'depth'],
  normal: ['object', 'normal'],
  event: ['object', 'position'],
  direction: [],
};

/** The same for channels that an effect text reads. */
export const AOVS_OF_SHADER_CHANNEL: Readonly<Record<ShaderChannel, readonly AovName[]>> = {
  image: [],
  there: ['object'],
  depth: AOVS_OF_EFFECT_CHANNEL.depth,
  normal: AOVS_OF_EFFECT_CHANNEL.normal,
  image2: [],
  albedo: ['object', 'albedo'],
  roughness: ['object', 'roughness'],
  metallic: ['object', 'metallic'],
  metallicRoughness: ['object', 'metallic', 'roughness'],
  apparent: AOVS_OF_EFFECT_CHANNEL.depth,
  clipDepth: AOVS_OF_EFFECT_CHANNEL.depth,
  event: AOVS_OF_EFFECT_CHANNEL.event,
  emissionTime: ['object', 'emission_time'],
  velocity: ['object', 'velocity'],
  doppler: ['object', 'doppler'],
  object: ['object'],
};

/** Applies an effect in f64; unchanged where the mask (its first channel) is 0. `second`: what `image2` of a text reads. */
export function applyEffect(
  of: EffectId | ShaderProgram,
  args: readonly number[],
  source: EffectInput,
  mask?: FloatImage,
  second?: FloatImage,
): FloatImage {
  const frame = new GBufferReader(source);
  const after =
    typeof of === 'string'
      ? EFFECT_FUNCTIONS[of](frame, clampEffectArguments(of, args))
      : applyShaderText(of, frame, args, source.view.t, second);
  return mask ? mixImages('normal', 1, source.image, after, mask) : after;
}
