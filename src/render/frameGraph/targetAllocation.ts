import { type FrameGraphPass, inputImages } from '../../scene/frameGraph/frameGraph.ts';

/** The light that an image is of, before any tone curve. */
export function linearSourceOf(image: number, steps: readonly FrameGraphPass[]): number {
  const step = steps[image];
  return step?.kind === 'tone' ? linearSourceOf(step.image, steps) : image;
}

/** The images that a step's passes read. */
const imagesReadBy = (step: FrameGraphPass, steps: readonly FrameGraphPass[]): readonly number[] =>
  step.kind === 'false-colour' && step.of === 'radiance' ? [linearSourceOf(step.image, steps)] : inputImages(step);

/**
 * Which target of a pool each step is drawn into: none that is still to be read. Light and stills have targets of their own, −1 here. A long chain needs two.
 */
export function allocateTargets(steps: readonly FrameGraphPass[]): {
  readonly slots: readonly number[];
  readonly count: number;
} {
  const lastUse = new Map<number, number>();
  steps.forEach((step, i) => {
    for (const image of imagesReadBy(step, steps)) lastUse.set(image, i);
  });
  const slots: number[] = [];
  const free: number[] = [];
  let count = 0;
  steps.forEach((step, i) => {
    slots.push(step.kind === 'light' || step.kind === 'still' ? -1 : (free.pop() ?? count++));
    for (const image of new Set(imagesReadBy(step, steps)))
      if (lastUse.get(image) === i && slots[image] >= 0) free.push(slots[image]);
  });
  return { slots, count };
}
