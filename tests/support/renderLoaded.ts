import type { RasterRenderer } from '../../src/render/api.ts';
import type { Sampling } from '../../src/render/settings.ts';
import type { PictureViews } from '../../src/scene/view/pictureViews.ts';
import type { RenderSettings } from '../../src/scene/view/view.ts';

/** Draws a picture once code that few pictures need is loaded. `nextFrame`: called before, for machines without a display. */
export async function renderLoaded(
  renderer: RasterRenderer,
  [views, settings, sampling]: readonly [PictureViews, RenderSettings, Sampling],
  nextFrame: () => void,
): Promise<void> {
  nextFrame();
  renderer.render(views, settings, sampling);
  while (renderer.info.waiting) {
    await new Promise((loaded) => setTimeout(loaded));
    nextFrame();
    renderer.render(views, settings, sampling);
  }
}
