import type { RasterRenderer } from '../render/api.ts';
import type { Preview, PreviewRequest } from '../render/previews.ts';
import type { FrameGraph } from '../scene/frameGraph/frameGraph.ts';
import type { PictureSize } from '../scene/view/pictureViews.ts';

/** What a pipeline may draw without: the page then keeps a resting picture as it is, compiles while drawing, and has nothing to point at. */
type OptionalAbility = 'accumulate' | 'precompile' | 'pick';

/** Draws on a canvas or into memory, synchronously, one frame after another: what the viewport asks of a pipeline. */
export interface InteractiveRenderer
  extends Omit<RasterRenderer, OptionalAbility>,
    Partial<Pick<RasterRenderer, OptionalAbility>> {
  /** Small pictures of a frame graph's passes beside the picture on show. Absent: nodes have no pictures. */
  createPreviews?(): PreviewSource;
}

/** Makes pictures of the passes of a frame graph; one call at a time. */
export interface PreviewSource {
  /** In the order of `requests`; undefined where there is no picture that they could be made of. */
  make(
    frameGraph: FrameGraph,
    requests: readonly PreviewRequest[],
    size: PictureSize,
  ): Promise<readonly Preview[] | undefined>;
  dispose(): void;
}
