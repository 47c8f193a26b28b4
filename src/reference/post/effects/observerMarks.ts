import { saturate } from '../../../math/saturate.ts';
import { addScaled, dot, length, lerp, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { OBSERVER_MARKS } from '../../../scene/frameGraph/effects.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

type PicturePoint = readonly [number, number];

/**
 * The observer in a picture from outside (`OutsideCamera`): a disc where he is, and an arrow to where he will be when light has gone from one ring to the next, βcT;
 * shorter than that to the first ring, at any speed. Rings: on surfaces, and where there are none on the horizontal plane through him, all points at distances
 * ncT, n = 1, 2 …, whose light of nT ago arrives now. arg1: T [s]; arg2: opacity of the rings; arg3: radius of the disc [px]. Unchanged if the camera is at his eye.
 */
export function observerMarks(
  frame: GBufferReader,
  [seconds = 1, opacity = 1, size = 0]: readonly number[],
): FloatImage {
  const { observer, image, speedOfLight } = frame;
  if (length(observer) === 0) return image;
  const spacing = speedOfLight * seconds;
  const at = frame.pixelOf(observer);
  const tip = frame.pixelOf(addScaled(observer, frame.beta, spacing));
  return image.map((x, y) => {
    const here: PicturePoint = [x + 0.5, y + 0.5];
    let color = lerp(image.at(x, y) as unknown as Vec3, OBSERVER_MARKS.ring, opacity * ringCover(frame, x, y, spacing));
    if (!at || size === 0) return color;
    const hidden = frame.isCovered(x, y) && frame.depth(x, y) < length(observer);
    const visible = hidden ? OBSERVER_MARKS.hidden : 1;
    if (tip) color = lerp(color, OBSERVER_MARKS.arrow, visible * arrowCover(here, at, tip, size));
    const rim = size - distanceTo(here, at);
    color = lerp(color, OBSERVER_MARKS.edge, visible * saturate(rim + 0.5));
    return lerp(color, OBSERVER_MARKS.body, visible * saturate(rim - OBSERVER_MARKS.border + 0.5));
  });
}

const smoothstep = ([from, to]: PicturePoint, x: number): number => {
  const t = saturate((x - from) / (to - from));
  return t * t * (3 - 2 * t);
};
const distanceTo = (a: PicturePoint, b: PicturePoint): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Coverage by rings; a pixel's distance from one is that in space over the change of distance from pixel to pixel. */
function ringCover(frame: GBufferReader, x: number, y: number, spacing: number): number {
  const covered = frame.isCovered(x, y);
  const away = (i: number, j: number): number | undefined =>
    covered ? surfaceDistance(frame, x + i, y + j) : planeDistance(frame, x + i, y + j);
  const here = away(0, 0);
  if (here === undefined) return 0;
  /** The smaller of the changes to both sides: that across a silhouette counts for nothing. */
  const change = (i: number, j: number): number =>
    Math.min(...[1, -1].map((side) => Math.abs((away(side * i, side * j) ?? Number.POSITIVE_INFINITY) - here)));
  const perPixel = Math.hypot(change(1, 0), change(0, 1));
  if (!(perPixel < spacing)) return 0;
  const nearest = Math.max(Math.round(here / spacing), 1);
  const { ringWidth, ringGap, farthest } = OBSERVER_MARKS;
  const line = saturate(ringWidth / 2 + 0.5 - Math.abs(here - nearest * spacing) / Math.max(perPixel, 1e-6 * spacing));
  return line * smoothstep(ringGap, spacing / perPixel) * (1 - smoothstep(farthest, here / spacing));
}

/** Of what a pixel shows from the observer [m]; undefined without a surface. */
const surfaceDistance = (frame: GBufferReader, x: number, y: number): number | undefined =>
  frame.isCovered(x, y) ? length(sub(frame.apparentPosition(x, y), frame.observer)) : undefined;

/** From the observer to where the line of sight meets the horizontal plane through him [m]; undefined if it does not. */
function planeDistance(frame: GBufferReader, x: number, y: number): number | undefined {
  const { observer, zenith } = frame;
  const direction = frame.apparentDirection(x, y);
  const along = dot(observer, zenith) / dot(direction, zenith);
  return along > 0 && Number.isFinite(along) ? length(sub(scale(direction, along), observer)) : undefined;
}

/** Coverage by a shaft from `from` to `to` with two barbs; none if it is shorter than the disc. */
function arrowCover(here: PicturePoint, from: PicturePoint, to: PicturePoint, size: number): number {
  const long = distanceTo(from, to);
  if (!(long > size)) return 0;
  const { arrowWidth, barb } = OBSERVER_MARKS;
  const [dx, dy] = [(to[0] - from[0]) / long, (to[1] - from[1]) / long];
  const back = size * barb.length;
  const barbTip = (side: number): PicturePoint => [
    to[0] - back * (dx - side * barb.slope * dy),
    to[1] - back * (dy + side * barb.slope * dx),
  ];
  const nearest = Math.min(...[from, barbTip(1), barbTip(-1)].map((end) => distanceToSegment(here, to, end)));
  return saturate(arrowWidth / 2 + 0.5 - nearest);
}

function distanceToSegment(p: PicturePoint, a: PicturePoint, b: PicturePoint): number {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const t = saturate(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / Math.max(x * x + y * y, 1e-12));
  return Math.hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}
