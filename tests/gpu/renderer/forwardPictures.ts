import type { RasterRenderer } from '../../../src/render/api.ts';
import type { Shading } from '../../../src/render/settings.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';

export const SIZE = { width: 240, height: 135 };

/** A picture drawn with a G-buffer and without. */
export interface ShadingComparison {
  /** Of the picture that may be drawn without. */
  readonly shading: Shading;
  /** Largest difference of a channel, in steps of 8 bits, and the fraction of channels that differ by more than one. */
  readonly largest: number;
  readonly wrong: number;
  /** Standard deviation of the channels: 0 where nothing is seen. */
  readonly deviation: number;
}

/** Draws a picture of the renderer's scene in both ways. */
export async function compareShadings(
  renderer: RasterRenderer,
  view: ViewPoint,
  settings: RenderSettings,
  beforeFrame: () => void,
): Promise<ShadingComparison> {
  const take = async (shading: RasterRenderer['shading']): Promise<Uint8Array> => {
    beforeFrame();
    renderer.shading = shading;
    renderer.render([view], settings);
    return renderer.readPixels();
  };
  const deferred = await take('deferred');
  if (renderer.info.shading !== 'deferred') throw new Error('it was to be drawn with a G-buffer');
  const forward = await take('auto');
  const { shading } = renderer.info;
  const differences = deferred.map((value, i) => Math.abs(value - forward[i]!));
  const mean = deferred.reduce((sum, value) => sum + value, 0) / deferred.length;
  const variance = deferred.reduce((sum, value) => sum + (value - mean) ** 2, 0) / deferred.length;
  return {
    shading,
    largest: differences.reduce((most, difference) => Math.max(most, difference), 0),
    wrong: differences.filter((difference) => difference > 1).length / differences.length,
    deviation: Math.sqrt(variance),
  };
}
