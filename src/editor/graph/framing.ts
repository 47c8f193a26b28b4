import type { Point } from '../../graph/commands.ts';
import { around, type Box } from './shape.ts';

/** How the canvas is looked at, as React Flow has it: where its origin is in the panel [px of the window], and how large it is. */
export interface View {
  readonly x: number;
  readonly y: number;
  readonly zoom: number;
}

/** The first sight of a graph, and what is looked at by itself, is no closer than this. */
const CLOSEST = 1.1;
/** Graphs of hundreds of nodes are all in sight. */
export const FARTHEST = 0.03;
/** Around what is in sight [px of the window]. */
const MARGIN = 16;
/** Rather than smaller than this, to what it could be, it lies under something. */
const LEAST = 0.5;

/** From the left, above, from the right and below [px of the window]. */
type Insets = readonly [left: number, top: number, right: number, bottom: number];

/**
 * All of some boxes, as large as can be without one under what lies over the canvas (`over`, in the panel). What lies in a corner is passed at its side, or below or
 * above it; or not at all, where the boxes leave that corner free.
 */
export function viewOf(boxes: readonly Box[], size: Point, over: readonly Box[]): View | undefined {
  const held = around(boxes);
  if (!held) return undefined;
  const views = waysPast(size, over).map((insets) => within(held, size, insets));
  const plain = views[0]!;
  const isFree = (view: View): boolean => !boxes.some((box) => over.some((each) => covers(each, box, view)));
  const best = views.filter(isFree).reduce<View>((a, b) => (b.zoom > a.zoom ? b : a), { ...plain, zoom: 0 });
  return best.zoom < LEAST * plain.zoom ? plain : best;
}

/** The margins that pass each overlay at none, at one or at the other side of it; the first pass none. */
function waysPast([width, height]: Point, over: readonly Box[]): readonly Insets[] {
  return over.reduce<readonly Insets[]>(
    (ways, { at: [x, y], size: [wide, high] }) => {
      const isLeft = x + wide / 2 < width / 2;
      const isAbove = y + high / 2 < height / 2;
      const beside: Insets = isLeft ? [x + wide, 0, 0, 0] : [0, 0, width - x, 0];
      const past: Insets = isAbove ? [0, y + high, 0, 0] : [0, 0, 0, height - y];
      return [undefined, beside, past].flatMap((more) => ways.map((way) => (more ? most(way, more) : way)));
    },
    [[0, 0, 0, 0]],
  );
}

const most = (a: Insets, b: Insets): Insets => [
  Math.max(a[0], b[0]),
  Math.max(a[1], b[1]),
  Math.max(a[2], b[2]),
  Math.max(a[3], b[3]),
];

function within(held: Box, [width, height]: Point, [left, top, right, bottom]: Insets): View {
  const room: Point = [width - left - right - 2 * MARGIN, height - top - bottom - 2 * MARGIN];
  const [wide, high] = held.size;
  const zoom = Math.min(CLOSEST, Math.max(FARTHEST, Math.min(room[0] / wide, room[1] / high)));
  return {
    x: left + MARGIN + (room[0] - wide * zoom) / 2 - held.at[0] * zoom,
    y: top + MARGIN + (room[1] - high * zoom) / 2 - held.at[1] * zoom,
    zoom,
  };
}

function covers(over: Box, { at, size }: Box, { x, y, zoom }: View): boolean {
  const start: Point = [at[0] * zoom + x, at[1] * zoom + y];
  return ([0, 1] as const).every(
    (axis) => start[axis] < over.at[axis] + over.size[axis] && over.at[axis] < start[axis] + size[axis] * zoom,
  );
}
