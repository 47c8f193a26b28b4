import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { boundingRect, type CanvasRect } from '../cards/cardGeometry.ts';

/** Viewport transform as in React Flow: position of the canvas origin in the panel [px of the window] and zoom. */
export interface ViewportTransform {
  readonly x: number;
  readonly y: number;
  readonly zoom: number;
}

/** Maximum zoom of the initial view and of automatic fits. */
const MAX_FIT_ZOOM = 1.1;
/** Low enough that graphs of hundreds of nodes fit. */
export const MIN_ZOOM = 0.03;
/** Margin around fitted nodes [px of the window]. */
const FIT_MARGIN = 16;
/** If avoiding the overlays shrinks the view below this fraction, nodes may lie under them. */
const MIN_ZOOM_RATIO = 0.5;

/** Left, top, right, bottom [px of the window]. */
type Insets = readonly [left: number, top: number, right: number, bottom: number];

/**
 * The largest view of all boxes that no overlay covers (`over`, in panel coordinates). Overlays in a corner are avoided
 * at their side, or vertically; or not at all where the boxes leave that corner free.
 */
export function fitTransform(
  boxes: readonly CanvasRect[],
  size: CanvasPoint,
  over: readonly CanvasRect[],
): ViewportTransform | undefined {
  const held = boundingRect(boxes);
  if (!held) return undefined;
  const views = overlayInsets(size, over).map((insets) => fitWithin(held, size, insets));
  const plain = views[0]!;
  const isFree = (view: ViewportTransform): boolean =>
    !boxes.some((box) => over.some((each) => isCovered(each, box, view)));
  const best = views
    .filter(isFree)
    .reduce<ViewportTransform>((a, b) => (b.zoom > a.zoom ? b : a), { ...plain, zoom: 0 });
  return best.zoom < MIN_ZOOM_RATIO * plain.zoom ? plain : best;
}

/** All combinations of margins that avoid each overlay on one of its sides or not at all; the first avoids none. */
function overlayInsets([width, height]: CanvasPoint, over: readonly CanvasRect[]): readonly Insets[] {
  return over.reduce<readonly Insets[]>(
    (candidates, { at: [x, y], size: [wide, high] }) => {
      const isLeft = x + wide / 2 < width / 2;
      const isAbove = y + high / 2 < height / 2;
      const beside: Insets = isLeft ? [x + wide, 0, 0, 0] : [0, 0, width - x, 0];
      const past: Insets = isAbove ? [0, y + high, 0, 0] : [0, 0, 0, height - y];
      return [undefined, beside, past].flatMap((more) =>
        candidates.map((candidate) => (more ? maxInsets(candidate, more) : candidate)),
      );
    },
    [[0, 0, 0, 0]],
  );
}

const maxInsets = (a: Insets, b: Insets): Insets => [
  Math.max(a[0], b[0]),
  Math.max(a[1], b[1]),
  Math.max(a[2], b[2]),
  Math.max(a[3], b[3]),
];

function fitWithin(
  held: CanvasRect,
  [width, height]: CanvasPoint,
  [left, top, right, bottom]: Insets,
): ViewportTransform {
  const room: CanvasPoint = [width - left - right - 2 * FIT_MARGIN, height - top - bottom - 2 * FIT_MARGIN];
  const [wide, high] = held.size;
  const zoom = Math.min(MAX_FIT_ZOOM, Math.max(MIN_ZOOM, Math.min(room[0] / wide, room[1] / high)));
  return {
    x: left + FIT_MARGIN + (room[0] - wide * zoom) / 2 - held.at[0] * zoom,
    y: top + FIT_MARGIN + (room[1] - high * zoom) / 2 - held.at[1] * zoom,
    zoom,
  };
}

function isCovered(over: CanvasRect, { at, size }: CanvasRect, { x, y, zoom }: ViewportTransform): boolean {
  const start: CanvasPoint = [at[0] * zoom + x, at[1] * zoom + y];
  return ([0, 1] as const).every(
    (axis) => start[axis] < over.at[axis] + over.size[axis] && over.at[axis] < start[axis] + size[axis] * zoom,
  );
}
