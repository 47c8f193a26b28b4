import { add, distance, length, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { type HypersurfaceChoice, hypersurfaceOf } from '../../physics/worldLines/hypersurface.ts';
import type { ObserverEvent } from '../../physics/worldLines/kinds/worldLineKind.ts';
import { type SampledLine, samplesUntil } from '../../physics/worldLines/samples.ts';
import { asInertial, hullPoints, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import type { BoundingSphere } from '../../scene/bounds/bounds.ts';

/** One event relative to the observer's: offset Δx [m], world frame; time c(t − t_o) [m of light]. */
export interface RelativeEvent {
  readonly offset: Vec3;
  readonly ahead: number;
}

/** The observer's event and proper velocity u, c [m/s], and the hypersurface that the picture shows. */
export interface Observation extends ObserverEvent, HypersurfaceChoice {
  readonly u: Vec3;
  readonly c: number;
}

/** Bounds of the intersection of the hypersurface with a world tube: all points within a radius of a world line. */
export interface WorldTubeSection {
  /** c(t − t_o) [m of light]: no point of the tube meets the hypersurface before `from` or after `to`. */
  readonly from: number;
  readonly to: number;
  readonly sphere: BoundingSphere;
  /** Where the line itself meets the hypersurface; undefined where only a part of the tube ahead of it does. */
  readonly anchor: RelativeEvent | undefined;
}

/** Where the world line meets the hypersurface; undefined behind a horizon. `lag` [m of light] shifts the hypersurface towards the future. */
export function intersect(line: WorldLine, observation: Observation, lag = 0): RelativeEvent | undefined {
  const observer = lag === 0 ? observation : { t: observation.t + lag / observation.c, position: observation.position };
  const { u, c } = observation;
  const event = hypersurfaceOf(observation).intersect(line, observer, u, c);
  return event && { offset: event.offset, ahead: lag + event.ahead };
}

/**
 * A point within `radius` of the line is at most `radius` nearer or farther than the line itself, so it meets the hypersurface between the times at
 * which the line meets the hypersurface shifted by ± radius (± steepness·radius). undefined if no part of the tube meets it.
 */
export function worldTubeSection(
  line: WorldLine,
  radius: number,
  observation: Observation,
): WorldTubeSection | undefined {
  const inertial = asInertial(line);
  if (inertial) return inertialSection(intersect(line, observation), radius, length(inertial.velocity) / observation.c);
  const reach = hypersurfaceOf(observation).steepness(observation.u) * radius;
  const last = intersect(line, observation, reach);
  if (!last) return undefined;
  const anchor = intersect(line, observation);
  const first = intersect(line, observation, -reach);
  // The line is behind the horizon at first, and so is its approach from the infinite past: nothing bounds the place.
  if (!first)
    return {
      from: Number.NEGATIVE_INFINITY,
      to: last.ahead,
      sphere: { center: last.offset, radius: Number.POSITIVE_INFINITY },
      anchor,
    };
  const { t, position, c } = observation;
  const between = hullPoints(line, t + first.ahead / c, t + last.ahead / c, c);
  const corners = [first.offset, last.offset, ...between.map((x) => sub(x, position))];
  return { from: first.ahead, to: last.ahead, sphere: sphereAround(corners, radius), anchor };
}

/** At constant speed v [c] no point within the radius meets the hypersurface more than radius/(1 − v) earlier or later: one intersection is enough. */
function inertialSection(anchor: RelativeEvent | undefined, radius: number, v: number): WorldTubeSection | undefined {
  if (!anchor) return undefined;
  const reach = radius / (1 - v);
  const sphere = { center: anchor.offset, radius: radius + v * reach };
  return { from: anchor.ahead - reach, to: anchor.ahead + reach, sphere, anchor };
}

function sphereAround(points: readonly Vec3[], radius: number): BoundingSphere {
  const middle = scale(add(points[0], points[1]), 0.5);
  return { center: middle, radius: radius + Math.max(...points.map((p) => distance(p, middle))) };
}

/** The samples [first, first + count) that the section needs, with one before and one after it; if these are more than `max`, the last of them. */
export function sampleWindow(
  line: SampledLine,
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

/** From the centre of a ball to the point of it that trails behind the acceleration, the first to emerge from behind the horizon [m]. */
export const trailingPoint = (acceleration: Vec3, radius: number): Vec3 => {
  const a = length(acceleration);
  return a > 0 ? scale(acceleration, -radius / a) : ZERO;
};

export const relativeTo = (point: Vec3, observation: Observation, anchor: RelativeEvent): Vec3 =>
  sub(sub(point, observation.position), anchor.offset);
