import { imagesOf, type Step } from '../../scene/plan.ts';

/** The light that an image is of, before any tone curve. */
export function lightUnder(image: number, steps: readonly Step[]): number {
  const step = steps[image];
  return step?.kind === 'tone' ? lightUnder(step.image, steps) : image;
}

/** The images that a step's passes read. */
const read = (step: Step, steps: readonly Step[]): readonly number[] =>
  step.kind === 'false-colour' && step.of === 'radiance' ? [lightUnder(step.image, steps)] : imagesOf(step);

/**
 * Which target of a pool each step is drawn into: none that is still to be read. Light and stills have targets of their own, −1 here. A long chain needs two.
 */
export function slotsOf(steps: readonly Step[]): { readonly slots: readonly number[]; readonly count: number } {
  const lastUse = new Map<number, number>();
  steps.forEach((step, i) => {
    for (const image of read(step, steps)) lastUse.set(image, i);
  });
  const slots: number[] = [];
  const free: number[] = [];
  let count = 0;
  steps.forEach((step, i) => {
    slots.push(step.kind === 'light' || step.kind === 'still' ? -1 : (free.pop() ?? count++));
    for (const image of new Set(read(step, steps)))
      if (lastUse.get(image) === i && slots[image] >= 0) free.push(slots[image]);
  });
  return { slots, count };
}
