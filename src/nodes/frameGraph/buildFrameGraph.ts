import { type Message, msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import {
  contentKey,
  type FrameGraph,
  type FrameGraphBuffer,
  type FrameGraphPass,
  type FrameGraphPassOf,
  inputImages,
  MAX_BUFFERS,
  MAX_PASSES,
  MAX_STILL_IMAGES,
} from '../../scene/frameGraph/frameGraph.ts';
import { BUFFER_SETTINGS, type BufferSettings } from '../../scene/settings/settings.ts';
import type { Scene } from '../../scene/types.ts';
import { VIEWS } from '../../scene/views/views.ts';
import type { GBufferSpec, ImageSpec, PictureSpec } from '../socketValues.ts';

/** A picture with too many parts. */
export class FrameGraphError extends MessageError {}

/** The primary of two G-buffers: the relativistic one. */
export const primaryGBuffer = (below: GBufferSpec, above: GBufferSpec): GBufferSpec =>
  VIEWS[below.view].relativistic || !VIEWS[above.view].relativistic ? below : above;

/**
 * The picture whose final pass makes `image`: exposure and tone curve are split off for metering and antialiasing;
 * G-buffers and passes are listed once each, however often the graph refers to them. Throws a FrameGraphError if there
 * are too many.
 */
export function buildPicture(image: ImageSpec): PictureSpec {
  const { gbuffer } = image;
  const { step: last } = image;
  const isFalse = last.kind === 'false-colour' && last.buffer === gbuffer;
  const shown = isFalse ? last.image : image;
  const toned = shown.step.kind === 'tone' ? shown.step : undefined;
  const light = toned ? toned.image : shown;
  const how = {
    ...gbuffer,
    image,
    tone: toned?.tone ?? 'linear',
    metering: toned?.metering ?? 'manual',
    exposure: toned?.exposure ?? 0,
    falseColor: isFalse ? last.of : 'none',
  } as const;
  const { plan: frameGraph, scenes } = buildFrameGraph(light, gbuffer);
  const [step] = frameGraph.passes;
  if (frameGraph.passes.length === 1 && step?.kind === 'light' && step.buffer === 0)
    return { ...how, shadows: step.shadows, occlusion: step.occlusion, scenes };
  const metered = frameGraph.passes.find((each) => each.kind === 'tone' && each.metering !== 'manual');
  const metering = metered?.kind === 'tone' ? metered.metering : how.metering;
  return { ...how, metering, shadows: true, occlusion: true, frameGraph, scenes };
}

/** A list without duplicates, compared by content. */
export class UniqueList<T> {
  readonly items: T[] = [];
  private readonly places = new Map<unknown, number>();
  private readonly most: number;
  private readonly what: Message;

  constructor(most: number, what: Message) {
    this.most = most;
    this.what = what;
  }

  indexOf(item: T, key: unknown): number {
    const existing = this.places.get(key);
    if (existing !== undefined) return existing;
    if (this.items.length === this.most)
      throw new FrameGraphError(msg`a picture is put together of ${this.most} ${this.what} at most; leave some out`);
    this.places.set(key, this.items.length);
    return this.items.push(item) - 1;
  }
}

function buildFrameGraph(
  image: ImageSpec,
  first: GBufferSpec,
): { readonly plan: FrameGraph; readonly scenes: readonly Scene[] } {
  const scenes = new UniqueList<Scene>(MAX_BUFFERS, msg`scenes`);
  const buffers = new UniqueList<FrameGraphBuffer>(MAX_BUFFERS, msg`G-buffers`);
  const steps = new UniqueList<FrameGraphPass>(MAX_PASSES, msg`steps`);
  const bufferPlace = (gbuffer: GBufferSpec): number => {
    const buffer = frameGraphBuffer(gbuffer, scenes.indexOf(gbuffer.scene, gbuffer.scene));
    return buffers.indexOf(buffer, contentKey(buffer));
  };
  bufferPlace(first);
  addPasses(image, steps, bufferPlace);
  if (steps.items.filter(({ kind }) => kind === 'still').length > MAX_STILL_IMAGES)
    throw new FrameGraphError(msg`a picture is put together of ${MAX_STILL_IMAGES} stills at most; leave some out`);
  return { plan: { extraBuffers: buffers.items.slice(1), passes: steps.items }, scenes: scenes.items };
}

export const frameGraphBuffer = (
  settings: BufferSettings & Pick<FrameGraphBuffer, 'outside' | 'capture'>,
  scene: number,
): FrameGraphBuffer =>
  ({
    scene,
    ...Object.fromEntries(BUFFER_SETTINGS.map((name) => [name, settings[name]])),
    ...(settings.outside && { outside: settings.outside }),
    ...(settings.capture && { capture: settings.capture }),
  }) as FrameGraphBuffer;

/** Adds the missing passes of an image; returns where each of its images is. */
export function addPasses(
  image: ImageSpec,
  steps: UniqueList<FrameGraphPass>,
  bufferPlace: (gbuffer: GBufferSpec) => number,
): ReadonlyMap<ImageSpec, number> {
  const places = new Map<ImageSpec, number>();
  for (const each of topologicalOrder(image)) {
    const step = indexedPass(each.step, (of) => places.get(of) ?? 0, bufferPlace);
    places.set(each, steps.indexOf(step, contentKey(step)));
  }
  return places;
}

/**
 * An image with all that it is made from, inputs first, each once. Iterative, since graphs may be deep and share
 * inputs.
 */
function topologicalOrder(image: ImageSpec): Set<ImageSpec> {
  const done = new Set<ImageSpec>();
  const open = [image];
  for (let at = open.at(-1); at; at = open.at(-1)) {
    const missing = inputImages(at.step).filter((of) => !done.has(of));
    if (missing.length > 0) open.push(...missing);
    else {
      done.add(at);
      open.pop();
    }
  }
  return done;
}

function indexedPass(
  step: FrameGraphPassOf<ImageSpec, GBufferSpec>,
  image: (of: ImageSpec) => number,
  buffer: (of: GBufferSpec) => number,
): FrameGraphPass {
  switch (step.kind) {
    case 'still':
      return step;
    case 'light':
    case 'occlusion':
      return { ...step, buffer: buffer(step.buffer) };
    case 'effect': {
      const { mask, second, ...rest } = step;
      const made = { ...rest, image: image(step.image), buffer: buffer(step.buffer) };
      return { ...made, ...(second && { second: image(second) }), ...(mask && { mask: image(mask) }) };
    }
    case 'mix': {
      const { mask, ...rest } = step;
      const made = { ...rest, below: image(step.below), above: image(step.above) };
      return mask ? { ...made, mask: image(mask) } : made;
    }
    case 'tone':
      return { ...step, image: image(step.image) };
    case 'false-colour':
      return { ...step, image: image(step.image), buffer: buffer(step.buffer) };
  }
}
