import { addScaled, dot, normalize, type Vec3 } from '../../math/vec3.ts';
import { boost, inverseBoost } from '../../physics/lorentz/boost.ts';
import { type FourVector, fourVector, spatial } from '../../physics/lorentz/fourVector.ts';
import { type Boost, properVelocityOf } from '../boost.ts';
import { type FlightState, observerOf } from '../flightState.ts';

/** An event in the world frame. */
export interface WorldEvent {
  /** World time [s]. */
  readonly t: number;
  /** [m] */
  readonly x: Vec3;
}

/** A straight line of events: from `start` on, by (dt, dx) for each part of it. With dt = 0 it is in a frozen instant. */
export interface WorldSegment {
  readonly start: WorldEvent;
  /** [s] */
  readonly dt: number;
  /** [m] */
  readonly dx: Vec3;
}

/** A surface where a line of events meets it. */
export interface Wall {
  /** The first event that is on both. */
  readonly event: WorldEvent;
  /** Of the surface there, world frame. */
  readonly velocity: Boost;
  /** Unit normal in the frame where the surface rests, on the world's axes carried by the pure boost; to either side. */
  readonly normal: Vec3;
}

/** What a flight may meet. */
export interface Obstacles {
  /** The first surface that a line of events meets, from its start to `end` times its length. */
  readonly first: (segment: WorldSegment, end: number) => Wall | undefined;
}

export function eventOf(state: FlightState): WorldEvent {
  const { t, position } = observerOf(state);
  return { t, x: position };
}

export const segmentTo = (start: WorldEvent, end: WorldEvent): WorldSegment => ({
  start,
  dt: end.t - start.t,
  dx: addScaled(end.x, start.x, -1),
});

/** A displacement (dt [s], dx [m]), in the frame where a wall rests [m]. c [m/s]. */
export const inWallFrame = (
  { velocity }: Pick<Wall, 'velocity'>,
  { dt, dx }: Pick<WorldSegment, 'dt' | 'dx'>,
  c: number,
): Vec3 => (velocity.rapidity === 0 ? dx : spatial(boost(fourVector(c * dt, dx), properVelocityOf(velocity))));

/** How far an event is before the plane of a wall, in the frame where the wall rests [m]; negative behind it. */
export const distanceTo = (wall: Wall, event: WorldEvent, c: number): number =>
  dot(wall.normal, inWallFrame(wall, segmentTo(wall.event, event), c));

/** Its unit normal as a four-vector of the world. */
export const worldNormal = ({ velocity, normal }: Wall): FourVector =>
  inverseBoost(fourVector(0, normal), properVelocityOf(velocity));

/** A wall as it is in a frozen instant of the world: at rest. */
export const frozen = (wall: Wall): Wall => ({
  ...wall,
  velocity: { direction: wall.velocity.direction, rapidity: 0 },
  normal: normalize(spatial(worldNormal(wall))),
});
