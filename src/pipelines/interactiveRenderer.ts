import type { RasterRenderer } from '../render/api.ts';
import type { Preview, PreviewRequest } from '../render/previews.ts';
import type { FrameGraph } from '../scene/frameGraph/frameGraph.ts';
import type { PictureSize } from '../scene/view/pictureSize.ts';

/** Optional methods: without them the page does not refine pictures at rest, compiles shaders while drawing, cannot pick, has no second picture, and films stand still. */
type OptionalAbility = 'accumulate' | 'precompile' | 'pick' | 'beside' | 'showDome';

/** Draws on a canvas or into memory, synchronously, one frame after another; used by the viewport. */
export interface InteractiveRenderer
  extends Omit<RasterRenderer, OptionalAbility>,
    Partial<Pick<RasterRenderer, OptionalAbility>> {
  /** Small pictures of a frame graph's passes beside the displayed picture. Absent: nodes have no previews. */
  createPreviews?(): PreviewSource;
}

/** Makes pictures of the passes of a frame graph; one call at a time. */
export interface PreviewSource {
  /** Returns the previews in the order of `requests`; undefined if there is no picture to make them from. */
  make(
    frameGraph: FrameGraph,
    requests: readonly PreviewRequest[],
    size: PictureSize,
  ): Promise<readonly Preview[] | undefined>;
  dispose(): void;
}
