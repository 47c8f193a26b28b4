import { cross, distance, dot, length, type Vec3 } from '../../math/vec3.ts';
import { apparentPosition } from '../../physics/optics/apparentPosition.ts';
import { emissionEvent } from '../../physics/worldLines/lightCone.ts';
import { simultaneitySlice, simultaneousPosition } from '../../physics/worldLines/simultaneity.ts';
import { properVelocityAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import type { ProbeObserver } from '../views/viewRecord.ts';

/** The lengths between two points, A and B. */
export interface MeasuredLengths {
  /** Between the directions in which the observer sees them [rad]. */
  readonly angle: number;
  /** Between their apparent positions, in the observer's frame [m]. */
  readonly apparent: number;
  /** Between their positions at the observer's moment, in his frame [m]. */
  readonly slice: number;
  /** In the frame in which A rests when its light leaves: to where B is at that moment of that frame [m]. */
  readonly rest: number;
}

/**
 * Three lengths between points with these world lines: as seen, in the observer's slice of simultaneity, and at rest. c [m/s]. undefined if the light of
 * one does not arrive. For points of a rigid body, uniform or Born rigid, the rest length is that of the body. docs/physics.md §3.3, §5.5.
 * @example
 * // The ends of a rod of 5 m that flies past at 0.6 c.
 * const end = (x: number) => ({ kind: 'uniform', position: [x, 8, 0], velocity: [6, 0, 0] }) as const;
 * const lengths = measureLengths(end(4), end(8), { t: 0, position: [0, 0, 0], u: [0, 0, 0] }, 10)!;
 * lengths.slice; // 4 m
 * lengths.rest; // 5 m
 */
export function measureLengths(
  a: WorldLine,
  b: WorldLine,
  observer: ProbeObserver,
  c: number,
): MeasuredLengths | undefined {
  const [seenA, seenB] = [a, b].map((line) => emissionEvent(line, observer, c));
  if (!seenA || !seenB) return undefined;
  const [p, q] = [seenA, seenB].map(({ offset }) => apparentPosition(offset, observer.u)) as [Vec3, Vec3];
  const now = (line: WorldLine, at: ProbeObserver): Vec3 =>
    simultaneousPosition(simultaneitySlice(line, at, at.u, c).offset, at.u);
  const withA = { t: seenA.t, position: seenA.position, u: properVelocityAt(a, seenA.t, c) };
  return {
    angle: Math.atan2(length(cross(p, q)), dot(p, q)),
    apparent: distance(p, q),
    slice: distance(now(a, observer), now(b, observer)),
    rest: length(now(b, withA)),
  };
}
