import type { PictureMaker } from '../../src/render/api.ts';
import type { Sampling } from '../../src/render/settings.ts';
import type { Flight } from './flights.ts';

/** Pictures before those that count: what follows others has had some. */
export const WARM = 12;

/** The pictures of a flight from number WARM on. `pump`: what a machine without a screen needs before each. */
export async function filmOf(
  renderer: PictureMaker,
  { scene, settings, view }: Flight,
  sampling: Sampling,
  count: number,
  pump: () => void = () => {},
): Promise<Uint8Array[]> {
  await renderer.setScene(scene);
  const film: Uint8Array[] = [];
  for (let i = sampling === 'temporal' ? 0 : WARM; i < WARM + count; i++) {
    pump();
    renderer.render(view(i), settings, sampling);
    if (i >= WARM) film.push(new Uint8Array(await renderer.readPixels()));
  }
  return film;
}
