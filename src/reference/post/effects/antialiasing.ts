import { MIN_CONTRAST_BASE } from '../../../scene/frameGraph/effects.ts';
import { FloatImage, type GBufferReader } from './effectInput.ts';

/** Direction along a boundary of pixel sides, and the channel of `edges` that holds its sides; the other channel holds the perpendicular ones. */
interface EdgeDirection {
  readonly i: number;
  readonly j: number;
  readonly own: 0 | 1;
}
/** Top sides of pixels lie along rows, left sides along columns. */
const TOP: EdgeDirection = { i: 1, j: 0, own: 1 };
const LEFT: EdgeDirection = { i: 0, j: 1, own: 0 };

/** End of a boundary: its distance [px], and where a perpendicular edge goes there: outwards, to the pixels before the boundary (½), inwards (−½), both (`forked`, 0) or nowhere (0). */
interface EdgeEnd {
  readonly length: number;
  readonly height: number;
  readonly forked: boolean;
}

/**
 * Morphological antialiasing. Stairs of hard edges are taken as samples of a straight line from the middle of one step to the middle of the next;
 * the part of a pixel that the line cuts off gets the neighbour's colour. A pixel side is an edge where its contrast exceeds the threshold and its
 * difference is at least half that of every other side of its two pixels, so that soft gradients beside hard edges do not count. A pixel that
 * differs from all four neighbours belongs to no line; it exchanges ⅛ of its colour over each side. Colours are mixed in linear light.
 * arg1: threshold; arg2: search distance for the ends of an edge [px]; arg3: strength for single pixels.
 * Sources: Reshetov, Morphological Antialiasing, HPG 2009; contrast adaptation and forked ends: Jimenez et al., SMAA, Eurographics 2012.
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
    // Where two lines meet in a step, the weight of the longer one dominates.
    const weights = [across, across, down, down].map((each) => (each > 0 ? each / (across + down) : 0));
    return image
      .at(x, y)
      .map((value, c) =>
        sides.reduce(
          (sum, { texel, spread, area }, k) => sum + (weights[k]! * area + spread) * (texel[c]! - value),
          value,
        ),
      );
  });
}

/** The largest difference of two colours' channels, and its ratio to the largest channel. */
function contrast(a: readonly number[], b: readonly number[]): readonly [number, number] {
  const difference = Math.max(...a.map((value, c) => Math.abs(value - b[c]!)));
  return [difference, difference / Math.max(...a, ...b, MIN_CONTRAST_BASE)];
}

/** Across the left and the top side of each pixel, with one more column and row: (both differences, both contrasts), of square roots of light. */
function contrastsOf(image: FloatImage): FloatImage {
  const roots = image.map((x, y) => image.at(x, y).map((value) => Math.sqrt(Math.max(value, 0))));
  return FloatImage.of(image.width + 1, image.height + 1, 4, (x, y) => {
    const [left, top] = [contrast(roots.at(x, y), roots.at(x - 1, y)), contrast(roots.at(x, y), roots.at(x, y - 1))];
    return [left[0], top[0], left[1], top[1]];
  });
}

/** (whether the left side is an edge, whether the top one is, whether the pixel differs from all four neighbours) */
function edgesAt(contrasts: FloatImage, x: number, y: number, threshold: number): readonly number[] {
  const here = contrasts.at(x, y);
  const isEdge = ({ i, j, own }: EdgeDirection): boolean => {
    const over = (dx: number, dy: number, side: 0 | 1): number => contrasts.at(x + dx, y + dy)[side]!;
    const turn = own === 1 ? 0 : 1;
    // The two parallel sides, and the four perpendicular ones that meet its ends.
    const parallel = [over(j, i, own), over(-j, -i, own)];
    const meeting = [over(0, 0, turn), over(i, j, turn), over(-j, -i, turn), over(i - j, j - i, turn)];
    return here[own + 2]! > threshold && 2 * here[own]! >= Math.max(...parallel, ...meeting);
  };
  const around = Math.min(here[2]!, here[3]!, contrasts.at(x + 1, y)[2]!, contrasts.at(x, y + 1)[3]!);
  return [isEdge(LEFT), isEdge(TOP), around > threshold].map(Number);
}

/** Area of the pixel before this one that this pixel's colour covers across their common side, and vice versa. */
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

/** ∫ (1 − 2s/d) ds over the pixel k … k+1 of a run of length d, up to its middle d/2: the area under a line from height 1 at the end to 0 in the middle. */
function partOf(k: number, d: number): number {
  const [from, to] = [Math.min(k, d / 2), Math.min(k + 1, d / 2)];
  return (to - from) * (1 - (from + to) / d);
}

function edgeEnd(
  edges: FloatImage,
  x: number,
  y: number,
  { i, j, own }: EdgeDirection,
  sign: 1 | -1,
  search: number,
): EdgeEnd {
  for (let n = 1; n <= search; n++) {
    const beyond = n * sign;
    const [px, py] = [x + beyond * i, y + beyond * j];
    const outside = px < 0 || py < 0 || px >= edges.width || py >= edges.height;
    if (outside) return { length: n - 1, height: 0, forked: false };
    // The side between two pixels is stored with the later one.
    const turn = sign > 0 ? n : 1 - n;
    const [tx, ty] = [x + turn * i, y + turn * j];
    const inwards = edges.at(tx, ty)[1 - own]!;
    const outwards = edges.at(tx - j, ty - i)[1 - own]!;
    if (inwards + outwards > 0 || !edges.at(px, py)[own])
      return { length: n - 1, height: (outwards - inwards) / 2, forked: inwards * outwards > 0 };
  }
  return { length: search, height: 0, forked: false };
}

/** Area of a pixel that each neighbour's colour covers: left, right, above, below. */
function sidesOf(covered: FloatImage, x: number, y: number) {
  const inside = (i: number, j: number): number => Number(x + i < covered.width && y + j < covered.height);
  return [
    { i: -1, j: 0, area: covered.at(x, y)[1]! },
    { i: 1, j: 0, area: inside(1, 0) * covered.at(x + 1, y)[0]! },
    { i: 0, j: -1, area: covered.at(x, y)[3]! },
    { i: 0, j: 1, area: inside(0, 1) * covered.at(x, y + 1)[2]! },
  ];
}
