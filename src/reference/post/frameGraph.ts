import type { Vec3 } from '../../math/vec3.ts';
import { EFFECTS } from '../../scene/frameGraph/effects.ts';
import { type FrameGraph, type FrameGraphPass, inputImages } from '../../scene/frameGraph/frameGraph.ts';
import { readShaderText } from '../../scene/shaderText/shaderText.ts';
import type { AovName, RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { bufferSettings } from '../../scene/view/view.ts';
import { decodeSrgb } from '../../spectrum/display/srgb.ts';
import { toneMap } from '../../spectrum/display/toneMap.ts';
import { AOVS_OF_EFFECT_CHANNEL, AOVS_OF_SHADER_CHANNEL, applyEffect } from './effects/applyEffect.ts';
import { FloatImage } from './effects/effectInput.ts';
import { mixImages } from './effects/mix.ts';
import { AOVS_OF_FALSE_COLOR, falseColorPicture, falseColorValues } from './falseColor.ts';
import { stillImage } from './still.ts';

/** A G-buffer of a picture as it was taken: what is asked for by `aovsOfFrameGraph`. */
export interface CapturedBuffer {
  readonly aovs: ReadonlyMap<AovName, Float32Array>;
  /** The scene's upward direction: unit, world frame. */
  readonly zenith: Vec3;
}

export interface CapturedBuffers {
  readonly view: ViewPoint;
  /** With the plan. */
  readonly settings: RenderSettings;
  readonly width: number;
  readonly height: number;
  readonly buffers: readonly CapturedBuffer[];
}

/** What each G-buffer of a plan is to be taken with. */
export function aovsOfFrameGraph(plan: FrameGraph): readonly (readonly AovName[])[] {
  const found = Array.from({ length: 1 + plan.extraBuffers.length }, () => new Set<AovName>());
  for (const step of plan.passes)
    if ('buffer' in step) for (const name of aovsOfStep(step)) found[step.buffer]!.add(name);
  return found.map((names) => [...names]);
}

function aovsOfStep(step: Extract<FrameGraphPass, { readonly buffer: number }>): readonly AovName[] {
  switch (step.kind) {
    case 'light':
      return ['beauty'];
    case 'occlusion':
      return ['object', 'occlusion'];
    case 'false-colour':
      return AOVS_OF_FALSE_COLOR[step.of].filter((name) => name !== 'beauty');
    case 'effect':
      return typeof step.effect === 'string'
        ? EFFECTS[step.effect].reads.flatMap((channel) => AOVS_OF_EFFECT_CHANNEL[channel])
        : [...readShaderText(step.effect.text).reads].flatMap((channel) => AOVS_OF_SHADER_CHANNEL[channel]);
  }
}

/** What a plan makes of pictures that were taken, in f64: the light that is then exposed and tone mapped. */
export function evaluateFrameGraph(taken: CapturedBuffers): FloatImage {
  const { frameGraph } = taken.settings;
  if (!frameGraph || frameGraph.passes.length === 0) throw new Error('there is no plan to carry out');
  const images: FloatImage[] = [];
  for (const step of frameGraph.passes) images.push(evaluateStep(step, images, taken, frameGraph.passes));
  return images.at(-1)!;
}

function evaluateStep(
  step: FrameGraphPass,
  images: readonly FloatImage[],
  taken: CapturedBuffers,
  steps: readonly FrameGraphPass[],
): FloatImage {
  const { view, width, height } = taken;
  const image = (i: number): FloatImage => images[i]!;
  const mask = (i: number | undefined) => (i === undefined ? undefined : image(i));
  switch (step.kind) {
    case 'light':
      return new FloatImage(width, height, 3, taken.buffers[step.buffer]!.aovs.get('beauty'));
    case 'still':
      return stillImage(step.still, width, height);
    case 'occlusion':
      return opennessImage(taken.buffers[step.buffer]!, width, height);
    case 'effect': {
      const { aovs, zenith } = taken.buffers[step.buffer]!;
      const settings = bufferSettings(taken.settings, step.buffer);
      const of = typeof step.effect === 'string' ? step.effect : readShaderText(step.effect.text);
      return applyEffect(of, step.args, { image: image(step.image), aovs, view, settings, zenith }, mask(step.mask));
    }
    case 'mix':
      return mixImages(step.mode, step.alpha, image(step.below), image(step.above), mask(step.mask));
    case 'tone': {
      const light = image(step.image);
      return light.map((x, y) => toneMap(light.at(x, y) as unknown as Vec3, step.exposure, step.tone));
    }
    case 'false-colour':
      return falseColorStep(step, images, taken, steps);
  }
}

/** 1 where nothing is. */
function opennessImage({ aovs }: CapturedBuffer, width: number, height: number): FloatImage {
  const [object, share] = [aovs.get('object')!, aovs.get('occlusion')!];
  return FloatImage.of(width, height, 3, (x, y) => {
    const i = y * width + x;
    const value = object[i]! > 0.5 ? share[i]! : 1;
    return [value, value, value];
  });
}

/** Luminance is that of the light before its tone curve; what lies under the bands is the image as it comes. */
function falseColorStep(
  { of, scale, image, buffer }: Extract<FrameGraphPass, { readonly kind: 'false-colour' }>,
  images: readonly FloatImage[],
  taken: CapturedBuffers,
  steps: readonly FrameGraphPass[],
): FloatImage {
  const { view, width, height } = taken;
  if (!scale) throw new Error(`the false colours of ${of} have no scale`);
  let under = image;
  if (of === 'radiance')
    for (let step = steps[under]; step?.kind === 'tone'; step = steps[under]) [under = 0] = inputImages(step);
  const beauty = Float32Array.from(images[under]!.values);
  const aovs = new Map(taken.buffers[buffer]!.aovs).set('beauty', beauty);
  const settings = { ...bufferSettings(taken.settings, buffer), tone: 'linear', exposure: 0 } as const;
  const source = { aovs, views: [view], settings, width, height } as const;
  const { pixels } = falseColorPicture({ kind: of, ...scale }, falseColorValues(of, source), source);
  return FloatImage.of(width, height, 3, (x, y) => {
    const i = 4 * (y * width + x);
    return [0, 1, 2].map((k) => decodeSrgb(pixels[i + k]! / 255));
  });
}
