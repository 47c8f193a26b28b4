import { length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { velocity } from '../../physics/lorentz/boost.ts';
import { relativeVelocity } from '../../physics/lorentz/velocity.ts';
import { terrellRotation } from '../../physics/optics/aberration.ts';
import { apparentPosition } from '../../physics/optics/apparentPosition.ts';
import { apparentRadialSpeed, apparentSpeedAcross, dopplerFactor } from '../../physics/optics/doppler.ts';
import { emissionEvent } from '../../physics/worldLines/lightCone.ts';
import { properTimeBetween } from '../../physics/worldLines/properTime.ts';
import { simultaneitySlice, simultaneousPosition } from '../../physics/worldLines/simultaneity.ts';
import { properVelocityAt, velocityAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import { clockStart } from '../clocks/clock.ts';
import { isAlive } from '../motion/lifetimes.ts';
import type { SceneObject } from '../types.ts';
import type { ProbeObserver } from '../views/viewRecord.ts';
import { type SurfaceEvent, surfaceLine } from './surfaceLine.ts';

/** A point of a surface as an observer sees it, and where it is at his moment. */
export interface Inspection {
  /** World time at which the light that is seen left [s]. */
  readonly emissionTime: number;
  /** Where it left, world frame [m]. */
  readonly emissionPosition: Vec3;
  /** What a clock of the point showed then [s], set to 0 at its birth, or at world time 0 if it always existed; undefined where its motion has no closed form. */
  readonly properTime: number | undefined;
  /** How far the light has travelled, in the observer's frame: the apparent distance [m]. */
  readonly distanceThen: number;
  /** How far the point is away at the observer's moment, in his frame [m]; undefined if it does not exist then, or its motion is not known. */
  readonly distanceNow: number | undefined;
  /** At emission, world frame, units of c. */
  readonly velocity: Vec3;
  /** At emission, in the observer's frame, units of c. */
  readonly relativeVelocity: Vec3;
  /** D = ν_observed/ν_emitted. */
  readonly doppler: number;
  /** Across the sky, in the observer's frame, units of c. */
  readonly apparentSpeedAcross: number;
  /** Along the line of sight, positive for what recedes, units of c. */
  readonly apparentRadialSpeed: number;
  /** Whether its apparent velocity exceeds c. */
  readonly superluminal: boolean;
  /** Angle by which the body appears turned [rad]. */
  readonly rotation: number;
}

/** How far an event may lie beside the light cone, in parts of its distance: 32-bit floats in pictures. */
const CONE_TOLERANCE = 1e-3;

/**
 * What an observer sees of the point of an object's surface that is at an event of a picture, in any view; c [m/s]. undefined if no light of it arrives.
 * A point whose motion is not known (samples that stay in files) is inspected at the event itself, which then must be on the observer's light cone.
 * docs/physics.md §3.
 * @example
 * // It recedes at 0.6 c and is 16 m away: seen where it was a second ago, at 10 m.
 * const motion: Motion = { kind: 'uniform', pose: { ...IDENTITY_POSE, position: [16, 0, 0] }, velocity: [6, 0, 0] };
 * const ball = makeObject({ path: '/Ball', mesh: sphere(1), motion });
 * const event = { time: -1, position: [10, 0, 0], velocity: [0.6, 0, 0] } as const;
 * const seen = inspectEvent(ball, event, { t: 0, position: [0, 0, 0], u: [0, 0, 0] }, 10)!;
 * seen.distanceThen; // 10 m
 * seen.distanceNow; // 16 m
 * seen.doppler; // 0.5
 * seen.apparentRadialSpeed; // 0.375 c
 */
export function inspectEvent(
  object: SceneObject,
  event: SurfaceEvent,
  observer: ProbeObserver,
  c: number,
): Inspection | undefined {
  const known = surfaceLine(object, event, c);
  if (!known && !isOnCone(event, observer, c)) return undefined;
  const line = known ?? coasting(event, c);
  const seen = emissionEvent(line, observer, c);
  if (!seen || !isAlive(object.lifetime, seen.t)) return undefined;
  const u = properVelocityAt(line, seen.t, c);
  const relative = relativeVelocity(u, observer.u);
  const beta = velocity(relative);
  const apparent = apparentPosition(seen.offset, observer.u);
  const n = normalize(apparent);
  const [across, radial] = [apparentSpeedAcross(n, beta), apparentRadialSpeed(n, beta)];
  return {
    emissionTime: seen.t,
    emissionPosition: seen.position,
    properTime: known && properTimeBetween(known, clockStart(object.lifetime), seen.t, c),
    distanceThen: length(apparent),
    distanceNow: known && distanceNow(object, known, observer, c),
    velocity: scale(velocityAt(line, seen.t, c), 1 / c),
    relativeVelocity: beta,
    doppler: dopplerFactor(seen.offset, observer.u, u),
    apparentSpeedAcross: across,
    apparentRadialSpeed: radial,
    superluminal: Math.hypot(across, radial) > 1,
    rotation: terrellRotation(n, relative),
  };
}

function distanceNow(object: SceneObject, line: WorldLine, observer: ProbeObserver, c: number): number | undefined {
  const { offset, ahead } = simultaneitySlice(line, observer, observer.u, c);
  if (!isAlive(object.lifetime, observer.t + ahead / c)) return undefined;
  return length(simultaneousPosition(offset, observer.u));
}

const coasting = ({ time, position, velocity: beta }: SurfaceEvent, c: number): WorldLine => {
  const v = scale(beta, c);
  return { kind: 'uniform', position: sub(position, scale(v, time)), velocity: v };
};

function isOnCone({ time, position }: SurfaceEvent, observer: ProbeObserver, c: number): boolean {
  const way = length(sub(position, observer.position));
  return Math.abs(way - c * (observer.t - time)) <= CONE_TOLERANCE * way;
}
