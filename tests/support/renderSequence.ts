import type { RasterRenderer } from '../../src/render/api.ts';
import type { Sampling } from '../../src/render/settings.ts';
import type { CameraPath } from './cameraPaths.ts';

/** Pictures before those that count: what follows others has had some. */
export const WARM_UP_FRAMES = 12;

/** The pictures of a flight from number WARM on. `pump`: what a machine without a screen needs before each. */
export async function renderSequence(
  renderer: RasterRenderer,
  { scene, settings, view }: CameraPath,
  sampling: Sampling,
  count: number,
  pump: () => void = () => {},
): Promise<Uint8Array[]> {
  await renderer.setScene(scene);
  const film: Uint8Array[] = [];
  for (let i = sampling === 'temporal' ? 0 : WARM_UP_FRAMES; i < WARM_UP_FRAMES + count; i++) {
    pump();
    renderer.render(view(i), settings, sampling);
    if (i >= WARM_UP_FRAMES) film.push(new Uint8Array(await renderer.readPixels()));
  }
  return film;
}
