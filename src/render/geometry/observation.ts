import { add, distance, length, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { HYPERSURFACES, type HypersurfaceName } from '../../physics/worldLines/hypersurface.ts';
import type { ObserverEvent } from '../../physics/worldLines/lightCone.ts';
import {
  type PolylineLine,
  positionAt,
  samplePosition,
  samplesUntil,
  type WorldLine,
} from '../../physics/worldLines/worldLine.ts';
import type { BoundingSphere } from '../../scene/bounds/bounds.ts';

/** One event relative to the observer's: offset Δx [m], world frame; time c(t − t_o) [m of light]. */
export interface RelativeEvent {
  readonly offset: Vec3;
  readonly ahead: number;
}

/** The observer's event and proper velocity u, c [m/s], and the surface that is looked at. */
export interface Observation extends ObserverEvent {
  readonly u: Vec3;
  readonly c: number;
  readonly hypersurface: HypersurfaceName;
}

/** What of a world line, and of all that is within a radius of it, lies on the surface. */
export interface WorldTubeSection {
  /** c(t − t_o) [m of light]: no point of the body meets the surface before `from` or after `to`. */
  readonly from: number;
  readonly to: number;
  readonly sphere: BoundingSphere;
  /** Where the line itself meets the surface; undefined where only a part of the body ahead of it does. */
  readonly anchor: RelativeEvent | undefined;
}

/** Where the world line meets the surface; undefined behind a horizon. `lag` [m of light] moves the surface towards the future. */
export function intersect(line: WorldLine, observation: Observation, lag = 0): RelativeEvent | undefined {
  const observer = lag === 0 ? observation : { t: observation.t + lag / observation.c, position: observation.position };
  const { u, c, hypersurface } = observation;
  const event = HYPERSURFACES[hypersurface].intersect(line, observer, u, c);
  return event && { offset: event.offset, ahead: lag + event.ahead };
}

/**
 * A point within `radius` of the line is at most `radius` nearer or farther than the line itself, so it meets the surface between the times at which
 * the line meets the surface moved by ± radius (± β·radius for a slice). undefined: nothing of it is ever seen.
 */
export function worldTubeSection(
  line: WorldLine,
  radius: number,
  observation: Observation,
): WorldTubeSection | undefined {
  if (line.kind === 'static') return inertialSection(intersect(line, observation), radius, 0);
  if (line.kind === 'uniform')
    return inertialSection(intersect(line, observation), radius, length(line.velocity) / observation.c);
  const gradient = HYPERSURFACES[observation.hypersurface].timeGradient(observation.u);
  const reach = (length(gradient.linear) + Math.abs(gradient.radial)) * radius;
  const last = intersect(line, observation, reach);
  if (!last) return undefined;
  const anchor = intersect(line, observation);
  const first = intersect(line, observation, -reach);
  // Behind the horizon at first: the approach from the infinite past is hidden too, so only the ball is unknown.
  if (!first)
    return {
      from: Number.NEGATIVE_INFINITY,
      to: last.ahead,
      sphere: { center: last.offset, radius: Number.POSITIVE_INFINITY },
      anchor,
    };
  const corners = [first.offset, last.offset, ...cornersBetween(line, first.ahead, last.ahead, observation)];
  return { from: first.ahead, to: last.ahead, sphere: sphereAround(corners, radius), anchor };
}

/** At constant speed v no point within the radius meets the surface more than radius/(1 − v) earlier or later. Most objects: one solve. */
function inertialSection(anchor: RelativeEvent | undefined, radius: number, v: number): WorldTubeSection | undefined {
  if (!anchor) return undefined;
  const reach = radius / (1 - v);
  const sphere = { center: anchor.offset, radius: radius + v * reach };
  return { from: anchor.ahead - reach, to: anchor.ahead + reach, sphere, anchor };
}

/** Where the line turns between two times: the corners of its path besides the ends. */
function cornersBetween(line: WorldLine, from: number, to: number, sight: Observation): Vec3[] {
  const time = (ahead: number) => sight.t + ahead / sight.c;
  if (line.kind === 'hyperbolic' && time(from) < line.t0 && line.t0 < time(to))
    return [sub(positionAt(line, line.t0, sight.c), sight.position)];
  if (line.kind !== 'polyline') return [];
  const [first, last] = [samplesUntil(line.times, time(from)), samplesUntil(line.times, time(to))];
  const corners: Vec3[] = [];
  for (let k = first; k < last; k++) corners.push(sub(samplePosition(line, k), sight.position));
  return corners;
}

function sphereAround(points: readonly Vec3[], radius: number): BoundingSphere {
  const middle = scale(add(points[0], points[1]), 0.5);
  return { center: middle, radius: radius + Math.max(...points.map((p) => distance(p, middle))) };
}

/** The samples that the span needs, as [first, count): one before and one after it too. At most `most`, around its end. */
export function sampleWindow(
  line: PolylineLine,
  { from, to }: WorldTubeSection,
  observation: Observation,
  max: number,
): [number, number] {
  const time = (ahead: number) => observation.t + ahead / observation.c;
  const n = line.times.length;
  const first = Math.min(Math.max(0, samplesUntil(line.times, time(from)) - 1), n - 2);
  const end = Math.min(n, Math.max(first + 2, samplesUntil(line.times, time(to)) + 1));
  return [Math.max(first, end - max), Math.min(max, end - first)];
}

/** e^φ at the event of a hyperbolic line: sinh φ = a(t − t₀)/c, along the acceleration. c(t − t_o) = `ahead` [m of light]. */
export function rapidityFactor(acceleration: Vec3, t0: number, ahead: number, observation: Observation): number {
  const a = length(acceleration) / (observation.c * observation.c);
  return Math.exp(Math.asinh(a * (observation.c * (observation.t - t0) + ahead)));
}

/** The point of the ball around the line's centre that the acceleration leaves behind: the first to come out from behind the horizon. */
export const trailingPoint = (acceleration: Vec3, radius: number): Vec3 => {
  const a = length(acceleration);
  return a > 0 ? scale(acceleration, -radius / a) : ZERO;
};

export const relativeTo = (point: Vec3, observation: Observation, anchor: RelativeEvent): Vec3 =>
  sub(sub(point, observation.position), anchor.offset);
