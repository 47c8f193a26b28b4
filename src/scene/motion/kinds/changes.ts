import { fromParts, type Mat4, scaledUniformly } from '../../../math/mat4.ts';
import { multiply, type Quat, rotate, toMatrix } from '../../../math/quat.ts';
import { add, addScaled, length, scale, type Vec3, ZERO } from '../../../math/vec3.ts';
import type { Pose, StaticMotion, UniformMotion } from '../../types.ts';

// What a motion can be changed by, whatever its kind.

/** World time of what a file has at its own time τ: t = a τ + b [s]. */
export interface LinearTimeMap {
  readonly a: number;
  readonly b: number;
}

export const toWorldTime = (t: number, { a, b }: LinearTimeMap): number => a * t + b;

/** x → position + orientation · (scale · x) [m]: turned, enlarged and carried, never sheared, so that every motion stays of its kind. */
export interface SimilarityTransform {
  readonly position: Vec3;
  readonly orientation: Quat;
  /** Above 0. */
  readonly scale: number;
}

export const transformPose = ({ position, orientation }: Pose, by: SimilarityTransform): Pose => ({
  position: add(by.position, rotate(by.orientation, scale(position, by.scale))),
  orientation: multiply(by.orientation, orientation),
});

/** Of a velocity or an acceleration. */
export const transformVelocity = (v: Vec3, by: SimilarityTransform): Vec3 => rotate(by.orientation, scale(v, by.scale));

/** Scale, then turn. */
export const linearOf = (orientation: Quat, s: number): Mat4 =>
  scaledUniformly(fromParts(toMatrix(orientation), ZERO), s);

/** A pose inside a frame, as a pose outside it. */
export const composePoses = (frame: Pose, { position, orientation }: Pose): Pose => ({
  position: add(frame.position, rotate(frame.orientation, position)),
  orientation: multiply(frame.orientation, orientation),
});

/** A flight along a straight line, as a motion sees it. */
export interface FlightPath {
  /** [m/s] */
  readonly velocity: Vec3;
  /** [s] */
  readonly at: number;
  readonly c: number;
  /** Where what is at a place at rest is in flight, at the time `at`. */
  readonly place: (x: Vec3) => Vec3;
  /** Of the scene's time [s]. */
  readonly range: number;
}

/** The flight of a frame from the pose that it has at the time `at`. */
export function flyPose(pose: Pose, { velocity, at, place }: FlightPath): StaticMotion | UniformMotion {
  const position = place(pose.position);
  if (length(velocity) === 0) return { kind: 'static', pose: { ...pose, position } };
  return { kind: 'uniform', pose: { ...pose, position: addScaled(position, velocity, -at) }, velocity };
}
