import type { Quat } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { BlendedPoints } from '../streaming/blendedPoints.ts';
import type { StreamedPoints } from '../streaming/storedPoints.ts';

/** World times between which the object exists, birth ≤ t < death [s]; ±Infinity without birth or death. */
export interface Lifetime {
  /** [s]; −Infinity: always existed. */
  readonly birth: number;
  /** [s]; Infinity: always will. */
  readonly death: number;
}

/** Position [m] and orientation: x_world = position + orientation · x_object. */
export interface Pose {
  /** Of the object's origin, world frame [m]. */
  readonly position: Vec3;
  /** From the object's axes to the world's. */
  readonly orientation: Quat;
}

/** The motion of an object's frame, or of each of its points, in the world. */
export type Motion = RigidMotion | SampledPointsMotion;

/** The motion of one frame in the world: of a rigid object, a light or a camera. */
export type RigidMotion = StaticMotion | UniformMotion | HyperbolicMotion | SampledMotion;

/** Always at rest. */
export interface StaticMotion {
  readonly kind: 'static';
  /** Its place and orientation, world frame. */
  readonly pose: Pose;
}
/** Constant velocity for all times, without rotation. */
export interface UniformMotion {
  readonly kind: 'uniform';
  /** At world time 0. */
  readonly pose: Pose;
  /** [m/s], |v| < c. */
  readonly velocity: Vec3;
}
/** Constant proper acceleration along a line, momentarily at rest at `t0`; for all times, before and after. */
export interface HyperbolicMotion {
  readonly kind: 'hyperbolic';
  /** At world time `t0`. */
  readonly pose: Pose;
  /** [m/s²]. With `authoredIn: 'rest'` it is the frame origin's, and the body is Born rigid. */
  readonly properAcceleration: Vec3;
  /** [s] */
  readonly t0: number;
}
/**
 * Rigid poses at increasing times. Between samples every *vertex* moves in a straight line from its place in one pose to its
 * place in the next; before the first and after the last sample it rests. Rotation is resampled so that the chord error stays small.
 */
export interface SampledMotion {
  readonly kind: 'sampled';
  /** [s], strictly increasing, at least 2. */
  readonly times: Float64Array;
  /** 7 per sample: position x y z [m], orientation x y z w (unit). */
  readonly poses: Float64Array;
}
/**
 * A deforming mesh: every vertex moves between its places at increasing times, in a straight line or, if velocities are given, along a cubic;
 * it rests outside them.
 */
export interface SampledPointsMotion {
  readonly kind: 'sampled-points';
  /** [s], strictly increasing, at least 2. */
  readonly times: Float64Array;
  /** Origin of `points` [m], chosen so that they keep their digits in f32. */
  readonly origin: Vec3;
  /**
   * One array per sample, 3 per vertex, world-oriented, relative to `origin` [m]; or a reference to files, if they are too
   * many for memory; or joints with their influences. Read them with `pointsAt` (samplePoints.ts), which handles all.
   */
  readonly points: readonly Float32Array[] | StreamedPoints | BlendedPoints;
  /**
   * Velocity of every vertex at each sample, world-oriented [m/s], 3 per vertex: between samples the vertex moves along the cubic Hermite curve, with its
   * bend reduced where it would exceed c (`bendFactor`). Absent for straight pieces, which all streamed and blended samples have.
   */
  readonly velocities?: readonly Float32Array[];
  /** World-frame normals per sample, if they were given or could be computed; else those of the mesh are used. Read them with `normalsAt`. */
  readonly normals?: readonly Float32Array[];
}
