import { toScreen } from '../../src/reference/display.ts';
import type { PictureMaker } from '../../src/render/api.ts';
import { filmOf } from '../support/film.ts';
import { type Flight, type Unrest, unrestOf } from '../support/flights.ts';

export const SIZE = { width: 96, height: 54 };
const PICTURES = 3;

/** Of one flight on one backend. */
export interface Figures {
  readonly edges: Unrest;
  readonly temporal: Unrest;
  /** Bytes in which a picture that was refined to its end differs from one of 8 × 8 samples; and how many samples that took. */
  readonly unlike: number;
  readonly refined: number;
  /** Numbers in which data and light differ from those of a picture of single samples, half refined and after the temporal film. */
  readonly shifted: number;
  /** Steps of 8 bits by which a picture without antialiasing is off the light at the pixels' centres. */
  readonly unsmooth: number;
}

export async function figuresOf(renderer: PictureMaker, flight: Flight, pump: () => void = () => {}): Promise<Figures> {
  const truth = await filmOf(renderer, flight, 8, PICTURES, pump);
  const single = await filmOf(renderer, flight, 1, PICTURES, pump);
  const centres = await numbersOf(renderer);
  const followed = await filmOf(renderer, flight, 'temporal', PICTURES, pump);
  let shifted = unlike(centres, await numbersOf(renderer));
  let refined = 1;
  for (; refined < 10; refined++) renderer.refine(8);
  shifted += unlike(centres, await numbersOf(renderer));
  while (renderer.refine(8)) refined++;
  const finest = new Uint8Array(await renderer.readPixels());
  return {
    edges: unrestOf(single, truth),
    temporal: unrestOf(followed, truth),
    unlike: unlike(finest, truth[PICTURES - 1]!),
    refined,
    shifted,
    unsmooth: await unsmooth(renderer, flight, pump),
  };
}

async function numbersOf(renderer: PictureMaker): Promise<number[]> {
  const names = ['object', 'position', 'doppler', 'depth'] as const;
  const data = await Promise.all(names.map((name) => renderer.readAov(name)));
  const picked = await renderer.pick(SIZE.width / 2, SIZE.height / 2);
  return [...data.flatMap((values) => [...values]), ...(picked?.light ?? [])];
}

async function unsmooth(renderer: PictureMaker, flight: Flight, pump: () => void): Promise<number> {
  const settings = { ...flight.settings, antialiasing: false, tone: 'linear' as const };
  pump();
  renderer.render(flight.view(0), settings, 'temporal');
  const shown = await renderer.readPixels();
  const centres = toScreen(await renderer.readAov('beauty'), SIZE.width, SIZE.height);
  return centres.reduce((most, value, i) => Math.max(most, Math.abs(value - shown[i]!)), 0);
}

const unlike = (a: ArrayLike<number>, b: ArrayLike<number>): number =>
  Array.from(a).filter((value, i) => value !== b[i]).length + Math.abs(a.length - b.length);
