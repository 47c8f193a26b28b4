import type { RasterRenderer } from '../../src/render/api.ts';
import type { Sampling } from '../../src/render/settings.ts';
import type { CameraPath } from './cameraPaths.ts';
import { renderLoaded } from './renderLoaded.ts';

/** Pictures rendered before those that are returned, so that the temporal history is filled. */
export const WARM_UP_FRAMES = 12;

/** The pictures of a camera path from number `WARM_UP_FRAMES` on. `pump`: called before each, for machines without a display. */
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
    await renderLoaded(renderer, [[view(i)], settings, sampling], pump);
    if (i >= WARM_UP_FRAMES) film.push(new Uint8Array(await renderer.readPixels()));
  }
  return film;
}
