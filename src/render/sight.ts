import { add, distance, length, scale, sub, type Vec3, ZERO } from '../math/vec3.ts';
import { velocity } from '../physics/boost.ts';
import { type ObserverEvent, pastLightCone } from '../physics/lightCone.ts';
import { simultaneitySlice } from '../physics/simultaneity.ts';
import { type PolylineLine, positionAt, samplePosition, samplesUntil, type WorldLine } from '../physics/worldLine.ts';
import type { Ball } from './cull.ts';

/** Which events of the scene a picture is made of. */
export type Surface = 'past-light-cone' | 'slice' | 'now';

/** One event relative to the observer's: offset Δx [m], world frame; time c(t − t_o) [m of light]. */
export interface RelativeEvent {
  readonly offset: Vec3;
  readonly ahead: number;
}

/** The observer's event and proper velocity u, c [m/s], and the surface that is looked at. */
export interface Sight extends ObserverEvent {
  readonly u: Vec3;
  readonly c: number;
  readonly surface: Surface;
}

/** What of a world line, and of all that is within a radius of it, lies on the surface. */
export interface Span {
  /** c(t − t_o) [m of light]: no point of the body meets the surface before `from` or after `to`. */
  readonly from: number;
  readonly to: number;
  readonly ball: Ball;
  /** Where the line itself meets the surface; undefined where only a part of the body ahead of it does. */
  readonly anchor: RelativeEvent | undefined;
}

/** Where the world line meets the surface; undefined behind a horizon. `lag` [m of light] moves the surface towards the future. */
export function meet(line: WorldLine, sight: Sight, lag = 0): RelativeEvent | undefined {
  const observer = lag === 0 ? sight : { t: sight.t + lag / sight.c, position: sight.position };
  if (sight.surface === 'past-light-cone') {
    const seen = pastLightCone(line, observer, sight.c);
    return seen && { offset: seen.offset, ahead: lag - seen.delay };
  }
  const slice = simultaneitySlice(line, observer, sight.surface === 'slice' ? sight.u : ZERO, sight.c);
  return { offset: slice.offset, ahead: lag + slice.ahead };
}

/**
 * A point within `radius` of the line is at most `radius` nearer or farther than the line itself, so it meets the surface between the times at which
 * the line meets the surface moved by ± radius (± β·radius for a slice). undefined: nothing of it is ever seen.
 */
export function spanOf(line: WorldLine, radius: number, sight: Sight): Span | undefined {
  if (line.kind === 'static') return steadySpan(meet(line, sight), radius, 0);
  if (line.kind === 'uniform') return steadySpan(meet(line, sight), radius, length(line.velocity) / sight.c);
  const reach = { 'past-light-cone': 1, slice: length(velocity(sight.u)), now: 0 }[sight.surface] * radius;
  const last = meet(line, sight, reach);
  if (!last) return undefined;
  const anchor = meet(line, sight);
  const first = meet(line, sight, -reach);
  // Behind the horizon at first: the approach from the infinite past is hidden too, so only the ball is unknown.
  if (!first)
    return {
      from: Number.NEGATIVE_INFINITY,
      to: last.ahead,
      ball: { centre: last.offset, radius: Number.POSITIVE_INFINITY },
      anchor,
    };
  const corners = [first.offset, last.offset, ...between(line, first.ahead, last.ahead, sight)];
  return { from: first.ahead, to: last.ahead, ball: ballAround(corners, radius), anchor };
}

/** At constant speed v no point within the radius meets the surface more than radius/(1 − v) earlier or later. Most objects: one solve. */
function steadySpan(anchor: RelativeEvent | undefined, radius: number, v: number): Span | undefined {
  if (!anchor) return undefined;
  const reach = radius / (1 - v);
  const ball = { centre: anchor.offset, radius: radius + v * reach };
  return { from: anchor.ahead - reach, to: anchor.ahead + reach, ball, anchor };
}

/** Where the line turns between two times: the corners of its path besides the ends. */
function between(line: WorldLine, from: number, to: number, sight: Sight): Vec3[] {
  const time = (ahead: number) => sight.t + ahead / sight.c;
  if (line.kind === 'hyperbolic' && time(from) < line.t0 && line.t0 < time(to))
    return [sub(positionAt(line, line.t0, sight.c), sight.position)];
  if (line.kind !== 'polyline') return [];
  const [first, last] = [samplesUntil(line.times, time(from)), samplesUntil(line.times, time(to))];
  const corners: Vec3[] = [];
  for (let k = first; k < last; k++) corners.push(sub(samplePosition(line, k), sight.position));
  return corners;
}

function ballAround(points: readonly Vec3[], radius: number): Ball {
  const middle = scale(add(points[0], points[1]), 0.5);
  return { centre: middle, radius: radius + Math.max(...points.map((p) => distance(p, middle))) };
}

/** The samples that the span needs, as [first, count): one before and one after it too. At most `most`, around its end. */
export function sampleWindow(line: PolylineLine, { from, to }: Span, sight: Sight, most: number): [number, number] {
  const time = (ahead: number) => sight.t + ahead / sight.c;
  const n = line.times.length;
  const first = Math.min(Math.max(0, samplesUntil(line.times, time(from)) - 1), n - 2);
  const end = Math.min(n, Math.max(first + 2, samplesUntil(line.times, time(to)) + 1));
  return [Math.max(first, end - most), Math.min(most, end - first)];
}

/** e^φ at the event of a hyperbolic line: sinh φ = a(t − t₀)/c, along the acceleration. c(t − t_o) = `ahead` [m of light]. */
export function rapidityFactor(acceleration: Vec3, t0: number, ahead: number, sight: Sight): number {
  const a = length(acceleration) / (sight.c * sight.c);
  return Math.exp(Math.asinh(a * (sight.c * (sight.t - t0) + ahead)));
}

/** The point of the ball around the line's centre that the acceleration leaves behind: the first to come out from behind the horizon. */
export const trailingPoint = (acceleration: Vec3, radius: number): Vec3 => {
  const a = length(acceleration);
  return a > 0 ? scale(acceleration, -radius / a) : ZERO;
};

export const relativeTo = (point: Vec3, sight: Sight, anchor: RelativeEvent): Vec3 =>
  sub(sub(point, sight.position), anchor.offset);
