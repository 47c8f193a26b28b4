import {
  BUFFER_SETTINGS,
  type BufferSettings,
  imagesOf,
  MOST_BUFFERS,
  MOST_STEPS,
  MOST_STILLS,
  type Plan,
  type PlannedBuffer,
  type Step,
  type StepOf,
  textOf,
} from '../scene/plan.ts';
import type { Scene } from '../scene/types.ts';
import type { GBuffer, Image, Picture } from './define.ts';

/** A picture that is put together of too much. */
export class PlanError extends Error {}

/** Of two, that of which the picture is first of all: the one that relativity has to do with. */
export const leading = (below: GBuffer, above: GBuffer): GBuffer =>
  below.view === 'galilean' && above.view !== 'galilean' ? above : below;

/**
 * The picture whose last step an image is: with its exposure and tone curve apart, which the metering and the antialiasing work on, and with its G-buffers and
 * steps in a list, each once, however often the graph refers to it. Throws a PlanError where there are too many.
 */
export function planned(image: Image): Picture {
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
  const { plan, scenes } = listed(light, gbuffer);
  const [step] = plan.steps;
  if (plan.steps.length === 1 && step?.kind === 'light' && step.buffer === 0)
    return { ...how, shadows: step.shadows, occlusion: step.occlusion, scenes };
  const metered = plan.steps.find((each) => each.kind === 'tone' && each.metering !== 'manual');
  const metering = metered?.kind === 'tone' ? metered.metering : how.metering;
  return { ...how, metering, shadows: true, occlusion: true, plan, scenes };
}

/** By content: what refers to the same is the same. */
export class List<T> {
  readonly items: T[] = [];
  private readonly places = new Map<unknown, number>();
  private readonly most: number;
  private readonly what: string;

  constructor(most: number, what: string) {
    this.most = most;
    this.what = what;
  }

  place(item: T, key: unknown): number {
    const known = this.places.get(key);
    if (known !== undefined) return known;
    if (this.items.length === this.most)
      throw new PlanError(`a picture is put together of ${this.most} ${this.what} at most; leave some out`);
    this.places.set(key, this.items.length);
    return this.items.push(item) - 1;
  }
}

function listed(image: Image, first: GBuffer): { readonly plan: Plan; readonly scenes: readonly Scene[] } {
  const scenes = new List<Scene>(MOST_BUFFERS, 'scenes');
  const buffers = new List<PlannedBuffer>(MOST_BUFFERS, 'G-buffers');
  const steps = new List<Step>(MOST_STEPS, 'steps');
  const bufferPlace = (gbuffer: GBuffer): number => {
    const buffer = plannedBuffer(gbuffer, scenes.place(gbuffer.scene, gbuffer.scene));
    return buffers.place(buffer, textOf(buffer));
  };
  bufferPlace(first);
  listSteps(image, steps, bufferPlace);
  if (steps.items.filter(({ kind }) => kind === 'still').length > MOST_STILLS)
    throw new PlanError(`a picture is put together of ${MOST_STILLS} stills at most; leave some out`);
  return { plan: { others: buffers.items.slice(1), steps: steps.items }, scenes: scenes.items };
}

export const plannedBuffer = (settings: BufferSettings, scene: number): PlannedBuffer =>
  ({ scene, ...Object.fromEntries(BUFFER_SETTINGS.map((name) => [name, settings[name]])) }) as PlannedBuffer;

/** Adds the steps that make an image, as far as they are not there; gives where each of its images is. */
export function listSteps(
  image: Image,
  steps: List<Step>,
  bufferPlace: (gbuffer: GBuffer) => number,
): ReadonlyMap<Image, number> {
  const places = new Map<Image, number>();
  for (const each of inOrder(image)) {
    const step = numbered(each.step, (of) => places.get(of) ?? 0, bufferPlace);
    places.set(each, steps.place(step, textOf(step)));
  }
  return places;
}

/** All that an image is made of, and it: each once, after all that it is made of. A graph may be deep, and what two inputs share is not to be gone through twice. */
function inOrder(image: Image): Set<Image> {
  const done = new Set<Image>();
  const open = [image];
  for (let at = open.at(-1); at; at = open.at(-1)) {
    const missing = imagesOf(at.step).filter((of) => !done.has(of));
    if (missing.length > 0) open.push(...missing);
    else {
      done.add(at);
      open.pop();
    }
  }
  return done;
}

function numbered(step: StepOf<Image, GBuffer>, image: (of: Image) => number, buffer: (of: GBuffer) => number): Step {
  switch (step.kind) {
    case 'still':
      return step;
    case 'light':
    case 'occlusion':
      return { ...step, buffer: buffer(step.buffer) };
    case 'effect': {
      const { mask, ...rest } = step;
      const made = { ...rest, image: image(step.image), buffer: buffer(step.buffer) };
      return mask ? { ...made, mask: image(mask) } : made;
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
