import { MIN_CONTRAST_BASE } from '../../../scene/frameGraph/effects.ts';
import { FloatImage, type GBufferReader } from './effectInput.ts';

/** The way along a boundary; the number of `edges` that holds it, and its turns the other. */
interface EdgeDirection {
  readonly i: number;
  readonly j: number;
  readonly own: 0 | 1;
}
/** The upper sides of pixels lie along rows, the left ones along columns. */
const TOP: EdgeDirection = { i: 1, j: 0, own: 1 };
const LEFT: EdgeDirection = { i: 0, j: 1, own: 0 };

/** Where a boundary goes from a pixel: how many pixels on, and there into what is before it (½), into the pixel's own side (−½), both ways, or neither (0). */
interface EdgeEnd {
  readonly length: number;
  readonly height: number;
  readonly forked: boolean;
}

/**
 * Morphological antialiasing. Stairs of hard edges are taken for what sampling left of a straight line: it runs from the middle of one step to the middle of the next,
 * and what it cuts off a pixel, its neighbour's colour covers. A side of a pixel is an edge where its contrast is more than the threshold, and what it differs by no
 * less than half of that of any other side of its two pixels: soft slopes beside hard edges are none. A pixel that differs from all four around it is none of a line; it gives and takes ⅛ over each side.
 * All of it in linear light. arg1: threshold; arg2: how far along an edge its ends are looked for [px]; arg3: how much of single pixels is spread.
 * Sources: Reshetov, Morphological Antialiasing, HPG 2009; the contrast's adaptation and forked ends: Jimenez et al., SMAA, Eurographics 2012.
 */
export function antialiasing(
  { image }: GBufferReader,
  [threshold = 0, search = 0, subpixel = 0]: readonly number[],
): FloatImage {
  const contrasts = contrastsOf(image);
  const edges = image.map((x, y) => edgesAt(contrasts, x, y, threshold));
  const covered = edges.map((x, y) => [LEFT, TOP].flatMap((run) => coveredAt(edges, x, y, run, search)), 4);
  return image.map((x, y) => {
    const sides = sidesOf(covered, x, y).map(({ i, j, area }) => {
      const spread = subpixel * Math.max(edges.at(x, y)[2]!, edges.at(x + i, y + j)[2]!);
      return { texel: image.at(x + i, y + j), spread: spread / 8, area: area * (1 - spread) };
    });
    const [left, right, top, bottom] = sides.map(({ area }) => area) as [number, number, number, number];
    const [across, down] = [(left + right) ** 4, (top + bottom) ** 4];
    // A step belongs to the longer of the lines that meet in it.
    const share = [across, across, down, down].map((each) => (each > 0 ? each / (across + down) : 0));
    return image
      .at(x, y)
      .map((value, c) =>
        sides.reduce(
          (sum, { texel, spread, area }, k) => sum + (share[k]! * area + spread) * (texel[c]! - value),
          value,
        ),
      );
  });
}

/** The largest difference of two colours' channels; and that over the largest channel. */
function contrast(a: readonly number[], b: readonly number[]): readonly [number, number] {
  const difference = Math.max(...a.map((value, c) => Math.abs(value - b[c]!)));
  return [difference, difference / Math.max(...a, ...b, MIN_CONTRAST_BASE)];
}

/** Over the left side of each pixel, and of those after the last, and over the upper one: (both differences, both contrasts). */
function contrastsOf(image: FloatImage): FloatImage {
  const roots = image.map((x, y) => image.at(x, y).map((value) => Math.sqrt(Math.max(value, 0))));
  return FloatImage.of(image.width + 1, image.height + 1, 4, (x, y) => {
    const [left, top] = [contrast(roots.at(x, y), roots.at(x - 1, y)), contrast(roots.at(x, y), roots.at(x, y - 1))];
    return [left[0], top[0], left[1], top[1]];
  });
}

/** (whether the left side is an edge, whether the upper one is, whether the pixel differs from all four around it) */
function edgesAt(contrasts: FloatImage, x: number, y: number, threshold: number): readonly number[] {
  const here = contrasts.at(x, y);
  const isEdge = ({ i, j, own }: EdgeDirection): boolean => {
    const over = (dx: number, dy: number, side: 0 | 1): number => contrasts.at(x + dx, y + dy)[side]!;
    const turn = own === 1 ? 0 : 1;
    // The two that are parallel to it, and those that meet its ends on both sides.
    const parallel = [over(j, i, own), over(-j, -i, own)];
    const meeting = [over(0, 0, turn), over(i, j, turn), over(-j, -i, turn), over(i - j, j - i, turn)];
    return here[own + 2]! > threshold && 2 * here[own]! >= Math.max(...parallel, ...meeting);
  };
  const around = Math.min(here[2]!, here[3]!, contrasts.at(x + 1, y)[2]!, contrasts.at(x, y + 1)[3]!);
  return [isEdge(LEFT), isEdge(TOP), around > threshold].map(Number);
}

/** How much this pixel covers of the one before a side of its, and that of it. */
function coveredAt(
  edges: FloatImage,
  x: number,
  y: number,
  run: EdgeDirection,
  search: number,
): readonly [number, number] {
  if (!edges.at(x, y)[run.own]) return [0, 0];
  const [start, end] = [edgeEnd(edges, x, y, run, -1, search), edgeEnd(edges, x, y, run, 1, search)];
  const length = start.length + end.length + 1;
  const areas = [
    (start.forked ? -end.height : start.height) * partOf(start.length, length),
    (end.forked ? -start.height : end.height) * partOf(end.length, length),
  ];
  const above = (side: number): number => areas.reduce((sum, area) => sum + Math.max(side * area, 0), 0);
  return [above(1), above(-1)];
}

/** ∫ (1 − 2s/d) ds over what lies before the middle d/2 of a run, of its pixel k … k+1: that of a line from height 1 at its end to 0 at its middle. */
function partOf(k: number, d: number): number {
  const [from, to] = [Math.min(k, d / 2), Math.min(k + 1, d / 2)];
  return (to - from) * (1 - (from + to) / d);
}

function edgeEnd(
  edges: FloatImage,
  x: number,
  y: number,
  { i, j, own }: EdgeDirection,
  way: 1 | -1,
  search: number,
): EdgeEnd {
  for (let n = 1; n <= search; n++) {
    const beyond = n * way;
    const [px, py] = [x + beyond * i, y + beyond * j];
    const outside = px < 0 || py < 0 || px >= edges.width || py >= edges.height;
    if (outside) return { length: n - 1, height: 0, forked: false };
    // Of the two pixels at the turn, the later one holds the side between them.
    const turn = way > 0 ? n : 1 - n;
    const [tx, ty] = [x + turn * i, y + turn * j];
    const inwards = edges.at(tx, ty)[1 - own]!;
    const outwards = edges.at(tx - j, ty - i)[1 - own]!;
    if (inwards + outwards > 0 || !edges.at(px, py)[own])
      return { length: n - 1, height: (outwards - inwards) / 2, forked: inwards * outwards > 0 };
  }
  return { length: search, height: 0, forked: false };
}

/** What each neighbour covers of a pixel: left, right, above, below. */
function sidesOf(covered: FloatImage, x: number, y: number) {
  const inside = (i: number, j: number): number => Number(x + i < covered.width && y + j < covered.height);
  return [
    { i: -1, j: 0, area: covered.at(x, y)[1]! },
    { i: 1, j: 0, area: inside(1, 0) * covered.at(x + 1, y)[0]! },
    { i: 0, j: -1, area: covered.at(x, y)[3]! },
    { i: 0, j: 1, area: inside(0, 1) * covered.at(x, y + 1)[2]! },
  ];
}
