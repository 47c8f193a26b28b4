import type { PictureSize } from '../../scene/view/pictureSize.ts';

/** From the left and the top [px]. */
type Place = readonly [left: number, top: number];

/** A label and the point that it belongs to [px]. */
export interface PointLabel extends PictureSize {
  /** Of the point, from the left and the top of the frame. */
  readonly x: number;
  readonly y: number;
  /** Of its corner from its point, when it was placed before. */
  readonly last?: Place | undefined;
}

interface TakenBox extends PictureSize {
  readonly left: number;
  readonly top: number;
}

/** Between a point and its label, and half of what labels leave free around a point [px]. */
const [GAP, POINT] = [10, 6];
/** How much better a place must be for a label to jump there [px], and what part of a jump that outweighs. */
const [MAX_INERTIA, INERTIA] = [8, 0.5];

/**
 * The top left corners of labels: to the right of their points, or to the left where there is no room, at their height; or as near to that as
 * leaves free the points and the labels before them. Undefined where there is no such place. A label that was placed before
 * stays on its side of others until another side is clearly better.
 */
export function labelPlaces(labels: readonly PointLabel[], frame: PictureSize): readonly (Place | undefined)[] {
  const taken: TakenBox[] = labels.map(({ x, y }) => ({
    left: x - POINT,
    top: y - POINT,
    width: 2 * POINT,
    height: 2 * POINT,
  }));
  return labels.map((label) => {
    const place = placeOf(label, taken, frame);
    if (place) taken.push({ left: place[0], top: place[1], width: label.width, height: label.height });
    return place;
  });
}

function placeOf(label: PointLabel, taken: readonly TakenBox[], frame: PictureSize): Place | undefined {
  const { x, y, width, height, last } = label;
  const lowest = frame.height - height;
  const middle = Math.max(0, Math.min(lowest, y - height / 2));
  const sides = [x + GAP, x - GAP - width].filter((left) => left >= 0 && left + width <= frame.width);
  const [wanted] = sides;
  let best: { readonly place: Place; readonly cost: number } | undefined;
  for (const left of sides) {
    const beside = taken.filter((other) => left < other.left + other.width && other.left < left + width);
    const isFree = (top: number): boolean =>
      top >= 0 &&
      top <= lowest &&
      beside.every((other) => top >= other.top + other.height || top + height <= other.top);
    for (const top of [middle, ...beside.flatMap((other) => [other.top + other.height, other.top - height])]) {
      const jump = last ? Math.hypot(left - x - last[0], top - y - last[1]) : 0;
      const cost = Math.hypot(left - wanted!, top - middle) + Math.min(MAX_INERTIA, INERTIA * jump);
      if ((!best || cost < best.cost) && isFree(top)) best = { place: [left, top], cost };
    }
  }
  return best?.place;
}
