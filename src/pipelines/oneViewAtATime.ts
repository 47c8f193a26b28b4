import type { PictureSize } from '../scene/view/pictureSize.ts';
import { assertViewports, blackPicture, composeViews, isWholePicture, viewportOf } from '../scene/view/pictureViews.ts';
import { AOVS, type ViewPoint } from '../scene/view/view.ts';
import type { PictureRequest, RenderedPicture } from './pictureRenderer.ts';

/** A request for one view, in a picture of its viewport's size. */
export interface SingleViewRequest extends Omit<PictureRequest, 'views'>, PictureSize {
  readonly view: ViewPoint;
}

type RenderSingleView = (request: SingleViewRequest, onPart?: (part: number) => void) => Promise<RenderedPicture>;

/** Renders the views of a picture as single pictures, one after another, and composes them. Throws a RangeError as `assertViewports`. */
export async function renderOneViewAtATime(
  { views, ...request }: PictureRequest,
  size: PictureSize,
  renderView: RenderSingleView,
  onPart: (part: number) => void = () => {},
): Promise<RenderedPicture> {
  assertViewports(views, size);
  if (isWholePicture(views)) return renderView({ ...request, ...size, view: views[0] }, onPart);
  const rects = views.map((view) => viewportOf(view, size));
  const area = rects.reduce((sum, { width, height }) => sum + width * height, 0);
  const pictures: RenderedPicture[] = [];
  let done = 0;
  for (const [i, view] of views.entries()) {
    const { width, height } = rects[i]!;
    const weight = (width * height) / area;
    pictures.push(await renderView({ ...request, width, height, view }, (part) => onPart(done + weight * part)));
    done += weight;
  }
  const { width, height } = size;
  const pixels = pictures.map((picture, i) => ({ rect: rects[i]!, values: picture.pixels }));
  return {
    pixels: request.pixels ? composeViews(pixels, size, 4, blackPicture(size)) : new Uint8Array(),
    aovs: new Map(
      request.aovs.map((name) => {
        const { length: channels } = AOVS[name].channels;
        const parts = pictures.map(({ aovs }, i) => ({ rect: rects[i]!, values: aovs.get(name)! }));
        return [name, composeViews(parts, size, channels, new Float32Array(channels * width * height))];
      }),
    ),
  };
}
