import { CancelledError } from '../graph/evaluation/evaluator.ts';
import type { AbortSignalLike, ProgressCallback } from '../graph/nodeType.ts';
import type { OptionValues } from '../pipelines/options.ts';
import type { PictureRenderer, PictureRequest } from '../pipelines/pictureRenderer.ts';
import type { UncheckedRequest } from '../pipelines/pipeline.ts';
import type { Scene } from '../scene/types.ts';
import type { PictureSize } from '../scene/view/pictureSize.ts';

/** Request for a picture that is rendered once; its speed of light is that of the settings. Plain data. */
export interface StillOrder extends PictureSize, Pick<PictureRequest, 'views' | 'settings' | 'samples'> {
  /** Id of the pipeline that draws it. */
  readonly pipeline: string;
  readonly scene: Scene;
  /** Options of that pipeline. */
  readonly options: OptionValues;
}

/**
 * Renders a picture: linear radiance, three values per pixel, rows from the top. Rejects with a `CancelledError` on the
 * signal; `progress` gets the completed fraction.
 */
export type RenderStill = (
  still: StillOrder,
  work: { readonly signal?: AbortSignalLike; readonly progress: ProgressCallback },
) => Promise<Float32Array<ArrayBuffer>>;

/** Renders one picture after another, since each uses all threads. */
export function queueStills(render: RenderStill): RenderStill {
  let before: Promise<unknown> = Promise.resolve();
  return (still, work) => {
    const drawn = before.then(() => {
      if (work.signal?.aborted) throw new CancelledError();
      return render(still, work);
    });
    before = drawn.catch(() => {});
    return drawn;
  };
}

/** Opens the still's pipeline for it. */
export const stillRequest = ({ scene, width, height, settings, options }: StillOrder): UncheckedRequest => ({
  scenes: [scene],
  size: { width, height },
  speedOfLight: settings.speedOfLight,
  options,
});

/** Radiance of the still, by a renderer that was opened for it. */
export async function lightOf(
  renderer: PictureRenderer,
  { views, settings, samples }: StillOrder,
  onPart: (part: number) => void,
): Promise<Float32Array<ArrayBuffer>> {
  const { aovs } = await renderer.render({ views, settings, samples, pixels: false, aovs: ['beauty'] }, onPart);
  // Renderers return no shared memory.
  return aovs.get('beauty') as Float32Array<ArrayBuffer>;
}
