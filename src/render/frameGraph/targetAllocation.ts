import { type FrameGraphPass, inputImages } from '../../scene/frameGraph/frameGraph.ts';

/** The image before tone mapping that an image was made from; itself if it is not tone mapped. */
export function linearSourceOf(image: number, passes: readonly FrameGraphPass[]): number {
  const pass = passes[image];
  return pass?.kind === 'tone' ? linearSourceOf(pass.image, passes) : image;
}

/** The images that a pass reads. */
const imagesReadBy = (pass: FrameGraphPass, passes: readonly FrameGraphPass[]): readonly number[] =>
  pass.kind === 'false-colour' && pass.of === 'radiance' ? [linearSourceOf(pass.image, passes)] : inputImages(pass);

/**
 * Assigns each pass a target of a pool, never one that a later pass still reads. −1 for light and stills, which have targets of their own. A long chain needs
 * two targets.
 */
export function allocateTargets(passes: readonly FrameGraphPass[]): {
  readonly slots: readonly number[];
  readonly count: number;
} {
  const lastUse = new Map<number, number>();
  passes.forEach((pass, i) => {
    for (const image of imagesReadBy(pass, passes)) lastUse.set(image, i);
  });
  const slots: number[] = [];
  const free: number[] = [];
  let count = 0;
  passes.forEach((pass, i) => {
    slots.push(pass.kind === 'light' || pass.kind === 'still' ? -1 : (free.pop() ?? count++));
    for (const image of new Set(imagesReadBy(pass, passes)))
      if (lastUse.get(image) === i && slots[image] >= 0) free.push(slots[image]);
  });
  return { slots, count };
}
