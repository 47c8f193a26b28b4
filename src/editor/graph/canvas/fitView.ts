import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { boundingRect, type CanvasRect } from '../cards/cardGeometry.ts';

/** How the canvas is looked at, as React Flow has it: where its origin is in the panel [px of the window], and how large it is. */
export interface ViewportTransform {
  readonly x: number;
  readonly y: number;
  readonly zoom: number;
}

/** The first sight of a graph, and what is looked at by itself, is no closer than this. */
const MAX_FIT_ZOOM = 1.1;
/** Graphs of hundreds of nodes are all in sight. */
export const MIN_ZOOM = 0.03;
/** Around what is in sight [px of the window]. */
const FIT_MARGIN = 16;
/** Rather than smaller than this, to what it could be, it lies under something. */
const MIN_ZOOM_RATIO = 0.5;

/** From the left, above, from the right and below [px of the window]. */
type Insets = readonly [left: number, top: number, right: number, bottom: number];

/**
 * All of some boxes, as large as can be without one under what lies over the canvas (`over`, in the panel). What lies in a corner is passed at its side, or below or
 * above it; or not at all, where the boxes leave that corner free.
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

/** The margins that pass each overlay at none, at one or at the other side of it; the first pass none. */
function overlayInsets([width, height]: CanvasPoint, over: readonly CanvasRect[]): readonly Insets[] {
  return over.reduce<readonly Insets[]>(
    (ways, { at: [x, y], size: [wide, high] }) => {
      const isLeft = x + wide / 2 < width / 2;
      const isAbove = y + high / 2 < height / 2;
      const beside: Insets = isLeft ? [x + wide, 0, 0, 0] : [0, 0, width - x, 0];
      const past: Insets = isAbove ? [0, y + high, 0, 0] : [0, 0, 0, height - y];
      return [undefined, beside, past].flatMap((more) => ways.map((way) => (more ? maxInsets(way, more) : way)));
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
