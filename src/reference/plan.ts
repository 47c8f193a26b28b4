import type { Vec3 } from '../math/vec3.ts';
import { EFFECTS } from '../scene/effects.ts';
import { bufferSettings, imagesOf, type Plan, type Step } from '../scene/plan.ts';
import { readShaderText } from '../scene/shaderText/shaderText.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view.ts';
import { decodeSrgb } from '../spectrum/srgb.ts';
import { toneMap } from '../spectrum/toneMap.ts';
import { Plane } from './effects/frame.ts';
import { AOVS_LOOKED_AT, AOVS_READ, applied } from './effects/library.ts';
import { mixed } from './effects/mix.ts';
import { AOVS_OF, falsePicture, falseValues } from './falseColor.ts';
import { fitted } from './still.ts';

/** A G-buffer of a picture as it was taken: what is asked for by `aovsOf`. */
export interface TakenBuffer {
  readonly aovs: ReadonlyMap<AovName, Float32Array>;
  /** The scene's upward direction: unit, world frame. */
  readonly zenith: Vec3;
}

export interface TakenPicture {
  readonly view: ViewPoint;
  /** With the plan. */
  readonly settings: RenderSettings;
  readonly width: number;
  readonly height: number;
  readonly buffers: readonly TakenBuffer[];
}

/** What each G-buffer of a plan is to be taken with. */
export function aovsOf(plan: Plan): readonly (readonly AovName[])[] {
  const found = Array.from({ length: 1 + plan.others.length }, () => new Set<AovName>());
  for (const step of plan.steps) if ('buffer' in step) for (const name of aovsFor(step)) found[step.buffer]!.add(name);
  return found.map((names) => [...names]);
}

function aovsFor(step: Extract<Step, { readonly buffer: number }>): readonly AovName[] {
  switch (step.kind) {
    case 'light':
      return ['beauty'];
    case 'occlusion':
      return ['object', 'occlusion'];
    case 'false-colour':
      return AOVS_OF[step.of].filter((name) => name !== 'beauty');
    case 'effect':
      return typeof step.effect === 'string'
        ? EFFECTS[step.effect].reads.flatMap((channel) => AOVS_READ[channel])
        : [...readShaderText(step.effect.text).reads].flatMap((channel) => AOVS_LOOKED_AT[channel]);
  }
}

/** What a plan makes of pictures that were taken, in f64: the light that is then exposed and tone mapped. */
export function composed(taken: TakenPicture): Plane {
  const { plan } = taken.settings;
  if (!plan || plan.steps.length === 0) throw new Error('there is no plan to carry out');
  const images: Plane[] = [];
  for (const step of plan.steps) images.push(made(step, images, taken, plan.steps));
  return images.at(-1)!;
}

function made(step: Step, images: readonly Plane[], taken: TakenPicture, steps: readonly Step[]): Plane {
  const { view, width, height } = taken;
  const image = (i: number): Plane => images[i]!;
  const mask = (i: number | undefined) => (i === undefined ? undefined : image(i));
  switch (step.kind) {
    case 'light':
      return new Plane(width, height, 3, taken.buffers[step.buffer]!.aovs.get('beauty'));
    case 'still':
      return fitted(step.still, width, height);
    case 'occlusion':
      return openness(taken.buffers[step.buffer]!, width, height);
    case 'effect': {
      const { aovs, zenith } = taken.buffers[step.buffer]!;
      const settings = bufferSettings(taken.settings, step.buffer);
      const of = typeof step.effect === 'string' ? step.effect : readShaderText(step.effect.text);
      return applied(of, step.args, { image: image(step.image), aovs, view, settings, zenith }, mask(step.mask));
    }
    case 'mix':
      return mixed(step.mode, step.alpha, image(step.below), image(step.above), mask(step.mask));
    case 'tone': {
      const light = image(step.image);
      return light.map((x, y) => toneMap(light.at(x, y) as unknown as Vec3, step.exposure, step.tone));
    }
    case 'false-colour':
      return falselyColored(step, images, taken, steps);
  }
}

/** 1 where nothing is. */
function openness({ aovs }: TakenBuffer, width: number, height: number): Plane {
  const [object, share] = [aovs.get('object')!, aovs.get('occlusion')!];
  return Plane.of(width, height, 3, (x, y) => {
    const i = y * width + x;
    const value = object[i]! > 0.5 ? share[i]! : 1;
    return [value, value, value];
  });
}

/** Luminance is that of the light before its tone curve; what lies under the bands is the image as it comes. */
function falselyColored(
  { of, scale, image, buffer }: Extract<Step, { readonly kind: 'false-colour' }>,
  images: readonly Plane[],
  taken: TakenPicture,
  steps: readonly Step[],
): Plane {
  const { view, width, height } = taken;
  if (!scale) throw new Error(`the false colours of ${of} have no scale`);
  let under = image;
  if (of === 'radiance')
    for (let step = steps[under]; step?.kind === 'tone'; step = steps[under]) [under = 0] = imagesOf(step);
  const beauty = Float32Array.from(images[under]!.values);
  const aovs = new Map(taken.buffers[buffer]!.aovs).set('beauty', beauty);
  const settings = { ...bufferSettings(taken.settings, buffer), tone: 'linear', exposure: 0 } as const;
  const source = { aovs, view, settings, width, height };
  const { pixels } = falsePicture({ kind: of, ...scale }, falseValues(of, source), source);
  return Plane.of(width, height, 3, (x, y) => {
    const i = 4 * (y * width + x);
    return [0, 1, 2].map((k) => decodeSrgb(pixels[i + k]! / 255));
  });
}
