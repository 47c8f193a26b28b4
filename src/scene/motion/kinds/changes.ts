import { fromParts, type Mat4, scaledUniformly } from '../../../math/mat4.ts';
import { multiply, type Quat, rotate, toMatrix } from '../../../math/quat.ts';
import { add, addScaled, length, scale, type Vec3, ZERO } from '../../../math/vec3.ts';
import type { Pose, StaticMotion, UniformMotion } from '../../types.ts';

// Changes that every kind of motion supports.

/** From a file's own time τ to world time: t = a τ + b [s]. */
export interface LinearTimeMap {
  readonly a: number;
  readonly b: number;
}

export const toWorldTime = (t: number, { a, b }: LinearTimeMap): number => a * t + b;

/** x → position + orientation · (scale · x) [m]: without shear, so that every motion keeps its kind. */
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

/** Transforms a velocity or an acceleration. */
export const transformVelocity = (v: Vec3, by: SimilarityTransform): Vec3 => rotate(by.orientation, scale(v, by.scale));

/** Scale, then turn. */
export const linearOf = (orientation: Quat, s: number): Mat4 =>
  scaledUniformly(fromParts(toMatrix(orientation), ZERO), s);

/** A pose inside a frame, as a pose outside it. */
export const composePoses = (frame: Pose, { position, orientation }: Pose): Pose => ({
  position: add(frame.position, rotate(frame.orientation, position)),
  orientation: multiply(frame.orientation, orientation),
});

/** A flight along a straight line, as motions apply it. */
export interface FlightPath {
  /** [m/s] */
  readonly velocity: Vec3;
  /** [s] */
  readonly at: number;
  readonly c: number;
  /** From a place at rest to the place in flight, at the time `at`. */
  readonly place: (x: Vec3) => Vec3;
  /** Length of the scene's time range [s]. */
  readonly range: number;
}

/** The flight of a frame with the pose that it has at the time `at`. */
export function flyPose(pose: Pose, { velocity, at, place }: FlightPath): StaticMotion | UniformMotion {
  const position = place(pose.position);
  if (length(velocity) === 0) return { kind: 'static', pose: { ...pose, position } };
  return { kind: 'uniform', pose: { ...pose, position: addScaled(position, velocity, -at) }, velocity };
}
