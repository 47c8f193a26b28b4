import type { Vec3 } from '../../math/vec3.ts';
import { EFFECTS } from '../../scene/frameGraph/effects.ts';
import { type FrameGraph, type FrameGraphPass, inputImages } from '../../scene/frameGraph/frameGraph.ts';
import type { SkyColors } from '../../scene/lights/skyGradient.ts';
import { drawnFrom, toObserver } from '../../scene/view/drawnFrom.ts';
import type { AovName, RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { bufferSettings } from '../../scene/view/view.ts';
import { decodeSrgb } from '../../spectrum/display/srgb.ts';
import { toneMap } from '../../spectrum/display/toneMap.ts';
import { AOVS_OF_EFFECT_CHANNEL, AOVS_OF_SHADER_CHANNEL, applyEffect } from './effects/applyEffect.ts';
import { FloatImage } from './effects/effectInput.ts';
import { mixImages } from './effects/mix.ts';
import { AOVS_OF_FALSE_COLOR, falseColorPicture, falseColorValues } from './falseColor.ts';
import { stillImage } from './still.ts';

/** A captured G-buffer, with the AOVs of `aovsOfFrameGraph`. */
export interface CapturedBuffer {
  readonly aovs: ReadonlyMap<AovName, Float32Array>;
  /** The scene's upward direction: unit, world frame. */
  readonly zenith: Vec3;
  /** Colours of its sky as a backdrop. */
  readonly sky?: SkyColors;
}

export interface CapturedBuffers {
  readonly view: ViewPoint;
  /** Including the frame graph. */
  readonly settings: RenderSettings;
  readonly width: number;
  readonly height: number;
  readonly buffers: readonly CapturedBuffer[];
}

/** The AOVs required of each G-buffer of a frame graph. */
export function aovsOfFrameGraph(graph: FrameGraph): readonly (readonly AovName[])[] {
  const found = Array.from({ length: 1 + graph.extraBuffers.length }, () => new Set<AovName>());
  for (const pass of graph.passes)
    if ('buffer' in pass) for (const name of aovsOfPass(pass)) found[pass.buffer]!.add(name);
  return found.map((names) => [...names]);
}

function aovsOfPass(pass: Extract<FrameGraphPass, { readonly buffer: number }>): readonly AovName[] {
  switch (pass.kind) {
    case 'light':
      return ['beauty'];
    case 'occlusion':
      return ['object', 'occlusion'];
    case 'false-colour':
      return AOVS_OF_FALSE_COLOR[pass.of].filter((name) => name !== 'beauty');
    case 'effect':
      return typeof pass.effect === 'string'
        ? EFFECTS[pass.effect].reads.flatMap((channel) => AOVS_OF_EFFECT_CHANNEL[channel])
        : pass.effect.program.reads.flatMap((channel) => AOVS_OF_SHADER_CHANNEL[channel]);
  }
}

/** Evaluates a frame graph on captured G-buffers in f64. Returns the light that is then exposed and tone mapped. */
export function evaluateFrameGraph(captured: CapturedBuffers): FloatImage {
  const { frameGraph } = captured.settings;
  if (!frameGraph || frameGraph.passes.length === 0) throw new Error('there is no plan to carry out');
  const images: FloatImage[] = [];
  for (const pass of frameGraph.passes) images.push(evaluatePass(pass, images, captured, frameGraph.passes));
  return images.at(-1)!;
}

function evaluatePass(
  pass: FrameGraphPass,
  images: readonly FloatImage[],
  captured: CapturedBuffers,
  passes: readonly FrameGraphPass[],
): FloatImage {
  const { view, width, height } = captured;
  const image = (i: number): FloatImage => images[i]!;
  const optional = (i: number | undefined) => (i === undefined ? undefined : image(i));
  switch (pass.kind) {
    case 'light':
      return new FloatImage(width, height, 3, captured.buffers[pass.buffer]!.aovs.get('beauty'));
    case 'still':
      return stillImage(pass.still, width, height);
    case 'occlusion':
      return opennessImage(captured.buffers[pass.buffer]!, width, height);
    case 'effect': {
      const { aovs, zenith, sky } = captured.buffers[pass.buffer]!;
      const settings = bufferSettings(captured.settings, pass.buffer);
      const of = typeof pass.effect === 'string' ? pass.effect : pass.effect.program;
      return applyEffect(
        of,
        pass.args,
        {
          ...{ image: image(pass.image), aovs, view: drawnFrom(view, settings), settings, zenith },
          observer: toObserver(view, settings),
          ...(sky && { sky }),
          ...(pass.fogColor && { fogColor: pass.fogColor }),
        },
        optional(pass.mask),
        optional(pass.second),
      );
    }
    case 'mix':
      return mixImages(pass.mode, pass.alpha, image(pass.below), image(pass.above), optional(pass.mask));
    case 'tone': {
      const light = image(pass.image);
      return light.map((x, y) => toneMap(light.at(x, y) as unknown as Vec3, pass.exposure, pass.tone));
    }
    case 'false-colour':
      return evaluateFalseColorPass(pass, images, captured, passes);
  }
}

/** The unoccluded fraction; 1 for the background. */
function opennessImage({ aovs }: CapturedBuffer, width: number, height: number): FloatImage {
  const [object, openness] = [aovs.get('object')!, aovs.get('occlusion')!];
  return FloatImage.of(width, height, 3, (x, y) => {
    const i = y * width + x;
    const value = object[i]! > 0.5 ? openness[i]! : 1;
    return [value, value, value];
  });
}

/** Radiance is measured before tone mapping passes; bands are shaded by the image as it is. */
function evaluateFalseColorPass(
  { of, scale, image, buffer }: Extract<FrameGraphPass, { readonly kind: 'false-colour' }>,
  images: readonly FloatImage[],
  captured: CapturedBuffers,
  passes: readonly FrameGraphPass[],
): FloatImage {
  const { view, width, height } = captured;
  if (!scale) throw new Error(`the false colours of ${of} have no scale`);
  let under = image;
  if (of === 'radiance')
    for (let pass = passes[under]; pass?.kind === 'tone'; pass = passes[under]) [under = 0] = inputImages(pass);
  const beauty = Float32Array.from(images[under]!.values);
  const aovs = new Map(captured.buffers[buffer]!.aovs).set('beauty', beauty);
  const settings = { ...bufferSettings(captured.settings, buffer), tone: 'linear', exposure: 0 } as const;
  const source = { aovs, views: [view], settings, width, height } as const;
  const { pixels } = falseColorPicture({ kind: of, ...scale }, falseColorValues(of, source), source);
  return FloatImage.of(width, height, 3, (x, y) => {
    const i = 4 * (y * width + x);
    return [0, 1, 2].map((k) => decodeSrgb(pixels[i + k]! / 255));
  });
}
