import type { PictureSize } from './pictureSize.ts';
import type { ViewPoint } from './view.ts';

/** A rectangle of a picture [px]; x from the left, y from the top, integers. */
export interface PixelRect {
  /** Left edge [px]. */
  readonly x: number;
  /** Top edge [px]. */
  readonly y: number;
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
}

/** One view of a picture, in its viewport. */
export interface PictureView extends ViewPoint {
  /** Absent: the whole picture. */
  readonly viewport?: PixelRect;
}

/** The views of a picture: usually one, two for a stereo pair, one per wall or cube face. Pixels outside all viewports are black. */
export type PictureViews = readonly [PictureView, ...PictureView[]];

export const viewportOf = ({ viewport }: PictureView, { width, height }: PictureSize): PixelRect =>
  viewport ?? { x: 0, y: 0, width, height };

/** Whether a picture has one view, which fills it. */
export const isWholePicture = (views: PictureViews): boolean => views.length === 1 && views[0].viewport === undefined;

export const rectContains = (rect: PixelRect, x: number, y: number): boolean =>
  x >= rect.x && y >= rect.y && x < rect.x + rect.width && y < rect.y + rect.height;

/** Throws a RangeError if a viewport is not made of whole pixels, is empty, extends beyond the picture or overlaps another. */
export function assertViewports(views: PictureViews, size: PictureSize): void {
  const rects = views.map((view) => viewportOf(view, size));
  rects.forEach((rect, i) => {
    const { x, y, width, height } = rect;
    const name = `viewport of view ${i + 1} (${x}, ${y}, ${width} × ${height})`;
    if (![x, y, width, height].every(Number.isInteger)) throw new RangeError(`${name}: whole pixels expected`);
    if (width < 1 || height < 1) throw new RangeError(`${name} is empty`);
    if (x < 0 || y < 0 || x + width > size.width || y + height > size.height)
      throw new RangeError(`${name} leaves the picture of ${size.width} × ${size.height} pixels`);
    const other = rects.findIndex((of, k) => k < i && overlap(of, rect));
    if (other >= 0) throw new RangeError(`${name} overlaps that of view ${other + 1}`);
  });
}

const overlap = (a: PixelRect, b: PixelRect): boolean =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** A point of a view's picture, relative to its viewport [px]. */
export interface ViewPixel extends PictureSize {
  readonly index: number;
  readonly view: PictureView;
  readonly x: number;
  readonly y: number;
}

/** The view at the point (x, y) of a picture; undefined if there is none. */
export function viewPixelAt(views: PictureViews, size: PictureSize, x: number, y: number): ViewPixel | undefined {
  const index = views.findIndex((view) => rectContains(viewportOf(view, size), x, y));
  if (index < 0) return undefined;
  const view = views[index];
  const { x: left, y: top, width, height } = viewportOf(view, size);
  return { index, view, x: x - left, y: y - top, width, height };
}

/** The views of a picture scaled by `factor`; viewports need not be whole pixels then. */
export function scaleViewports(views: PictureViews, factor: number): PictureViews {
  const scaled = (view: PictureView): PictureView => {
    if (!view.viewport) return view;
    const { x, y, width, height } = view.viewport;
    const viewport = { x: factor * x, y: factor * y, width: factor * width, height: factor * height };
    return { ...view, viewport };
  };
  const [first, ...others] = views;
  return [scaled(first), ...others.map(scaled)];
}

/** An opaque black picture, RGBA8. */
export const blackPicture = ({ width, height }: PictureSize): Uint8Array =>
  new Uint8Array(4 * width * height).map((_, i) => (i % 4 === 3 ? 255 : 0));

/** Copies the pixels of views, `channels` values each, rows from the top, into their viewports of the picture `into`. */
export function composeViews<Values extends Float32Array | Uint8Array>(
  parts: readonly { readonly rect: PixelRect; readonly values: Values }[],
  { width }: PictureSize,
  channels: number,
  into: Values,
): Values {
  for (const { rect, values } of parts)
    for (let row = 0; row < rect.height; row++) {
      const from = row * rect.width * channels;
      into.set(values.subarray(from, from + rect.width * channels), ((rect.y + row) * width + rect.x) * channels);
    }
  return into;
}
