import { encodeDisplay } from '../../../src/reference/post/encodeDisplay.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { type CameraPath, type TemporalError, temporalError } from '../../support/cameraPaths.ts';
import { renderSequence } from '../../support/renderSequence.ts';

export const SIZE = { width: 96, height: 54 };
const PICTURES = 3;

/** Measurements of one camera path on one backend. */
export interface Figures {
  readonly edges: TemporalError;
  readonly temporal: TemporalError;
  /** Number of bytes in which a completely accumulated picture differs from one of 8 × 8 samples, and the number of samples used. */
  readonly unlike: number;
  readonly refined: number;
  /** Number of values in which data and light differ from those of a single-sample picture, half accumulated and after the temporal sequence. */
  readonly shifted: number;
  /** Greatest difference, in 8-bit steps, of a picture without antialiasing from the light at the pixel centres. */
  readonly unsmooth: number;
}

export async function figuresOf(
  renderer: RasterRenderer,
  flight: CameraPath,
  pump: () => void = () => {},
): Promise<Figures> {
  const truth = await renderSequence(renderer, flight, 8, PICTURES, pump);
  const single = await renderSequence(renderer, flight, 1, PICTURES, pump);
  const centers = await numbersOf(renderer);
  const followed = await renderSequence(renderer, flight, 'temporal', PICTURES, pump);
  let shifted = unlike(centers, await numbersOf(renderer));
  let refined = 1;
  for (; refined < 10; refined++) renderer.accumulate(8);
  shifted += unlike(centers, await numbersOf(renderer));
  while (renderer.accumulate(8)) refined++;
  const finest = new Uint8Array(await renderer.readPixels());
  return {
    edges: temporalError(single, truth),
    temporal: temporalError(followed, truth),
    unlike: unlike(finest, truth[PICTURES - 1]!),
    refined,
    shifted,
    unsmooth: await unsmooth(renderer, flight, pump),
  };
}

async function numbersOf(renderer: RasterRenderer): Promise<number[]> {
  const names = ['object', 'position', 'doppler', 'depth'] as const;
  const data = await Promise.all(names.map((name) => renderer.readAov(name)));
  const picked = await renderer.pick(SIZE.width / 2, SIZE.height / 2);
  return [...data.flatMap((values) => [...values]), ...(picked?.light ?? [])];
}

async function unsmooth(renderer: RasterRenderer, flight: CameraPath, pump: () => void): Promise<number> {
  const settings = { ...flight.settings, antialiasing: false, tone: 'linear' as const };
  pump();
  renderer.render([flight.view(0)], settings, 'temporal');
  const shown = await renderer.readPixels();
  const centers = encodeDisplay(await renderer.readAov('beauty'), SIZE.width, SIZE.height);
  return centers.reduce((most, value, i) => Math.max(most, Math.abs(value - shown[i]!)), 0);
}

const unlike = (a: ArrayLike<number>, b: ArrayLike<number>): number =>
  Array.from(a).filter((value, i) => value !== b[i]).length + Math.abs(a.length - b.length);
