import type { PictureSize } from '../../scene/view/pictureViews.ts';

/** A label and the point that it belongs to [px]. */
export interface PointLabel extends PictureSize {
  /** Of the point, from the left and the top of the frame. */
  readonly x: number;
  readonly y: number;
}

/** The top left corner of a label [px]. */
type LabelCorner = readonly [left: number, top: number];

/** Between a point and its label [px]. */
const GAP = 10;

/**
 * Where labels go: to the right of their points, or to the left where there is no room, at their height, or as near to that as others
 * before them and the frame leave room.
 */
export function labelPlaces(labels: readonly PointLabel[], frame: PictureSize): readonly LabelCorner[] {
  const placed: { left: number; top: number; width: number; height: number }[] = [];
  for (const { x, y, width, height } of labels) {
    const right = x + GAP;
    const left = right + width <= frame.width ? right : Math.max(0, x - GAP - width);
    const beside = placed.filter((other) => left < other.left + other.width && other.left < left + width);
    const lowest = Math.max(0, frame.height - height);
    const wanted = Math.max(0, Math.min(lowest, y - height / 2));
    const isFree = (top: number) =>
      beside.every((other) => top >= other.top + other.height || top + height <= other.top);
    const [top = wanted] = [wanted, ...beside.flatMap((other) => [other.top + other.height, other.top - height])]
      .filter((each) => each >= 0 && each <= lowest && isFree(each))
      .sort((a, b) => Math.abs(a - wanted) - Math.abs(b - wanted));
    placed.push({ left, top, width, height });
  }
  return placed.map(({ left, top }) => [left, top]);
}
