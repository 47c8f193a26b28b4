import { radians } from '../../math/angle.ts';

/** A point in the plane of a glyph: x to the right, y up. */
export type Point2 = readonly [x: number, y: number];

/** A straight line to `to`, or, with `control`, the quadratic curve (1 − t)² P + 2t (1 − t) C + t² Q. */
export interface ContourSegment {
  readonly control?: Point2;
  readonly to: Point2;
}

/** A closed curve with the filled side to its right, as in TrueType: holes run the other way round. */
export interface Contour {
  readonly start: Point2;
  readonly segments: readonly ContourSegment[];
}

/** A glyph in font units; capitals are `capHeight` high. */
export interface Glyph {
  readonly contours: readonly Contour[];
  /** Advance width. */
  readonly advance: number;
  readonly capHeight: number;
}

/** A contour as line segments: corners, and the outward normals at both ends of the segment that starts at each. */
export interface FlattenedContour {
  readonly corners: readonly Point2[];
  readonly sides: readonly { readonly from: Point2; readonly to: Point2 }[];
}

/** Segments that meet at a smaller angle are smooth [rad]. */
const CREASE = radians(25);

/**
 * Flattens curves into the fewest segments within `tolerance`: a quadratic’s chord over 1/n of it is at most |P − 2C
 * + Q| / 4n² away (Sederberg, CAGD course notes, §10.6). Normals are those of the curve, not of the segments.
 */
export function flattenContour({ start, segments }: Contour, tolerance: number): FlattenedContour {
  const corners: Point2[] = [];
  const sides: { from: Point2; to: Point2 }[] = [];
  let at = start;
  for (const stroke of segments) {
    for (const piece of flattenSegment(at, stroke, tolerance)) {
      if (piece.end[0] === at[0] && piece.end[1] === at[1]) continue;
      corners.push(at);
      sides.push({ from: piece.from, to: piece.to });
      at = piece.end;
    }
  }
  return { corners, sides: smoothed(sides) };
}

interface Piece {
  readonly end: Point2;
  readonly from: Point2;
  readonly to: Point2;
}

function flattenSegment(from: Point2, { control, to }: ContourSegment, tolerance: number): Piece[] {
  if (!control) {
    const normal = outward(from, to);
    return [{ end: to, from: normal, to: normal }];
  }
  const bend = Math.hypot(from[0] - 2 * control[0] + to[0], from[1] - 2 * control[1] + to[1]);
  const count = Math.max(1, Math.ceil(Math.sqrt(bend / (4 * tolerance))));
  const normalAt = (t: number): Point2 => outward(between(from, control, t), between(control, to, t));
  return Array.from({ length: count }, (_, i) => {
    const t = (i + 1) / count;
    const end = i + 1 === count ? to : between(between(from, control, t), between(control, to, t), t);
    return { end, from: normalAt(i / count), to: normalAt(t) };
  });
}

const between = (a: Point2, b: Point2, t: number): Point2 => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];

/** Normal to the left of a → b, which is outside. */
function outward(a: Point2, b: Point2): Point2 {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const length = Math.hypot(x, y) || 1;
  return [-y / length, x / length];
}

/** Segments that meet smoothly share their mean normal. */
function smoothed(sides: { from: Point2; to: Point2 }[]): FlattenedContour['sides'] {
  sides.forEach((side, i) => {
    const next = sides[(i + 1) % sides.length];
    const [x, y] = [side.to[0] + next.from[0], side.to[1] + next.from[1]];
    // |a + b| = 2 cos(angle / 2).
    const length = Math.hypot(x, y);
    if (length < 2 * Math.cos(CREASE / 2)) return;
    side.to = [x / length, y / length];
    next.from = side.to;
  });
  return sides;
}

/** Twice the signed area of a polygon, negative if clockwise (shoelace formula). */
export const twiceArea = (corners: readonly Point2[]): number =>
  corners.reduce((sum, [x, y], i) => {
    const [nx, ny] = corners[(i + 1) % corners.length];
    return sum + x * ny - nx * y;
  }, 0);
