import type { Quat } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { StreamedPoints } from '../streaming/storedPoints.ts';

/** World times between which the object exists [s]; ±Infinity where it always did or always will. */
export interface Lifetime {
  readonly birth: number;
  readonly death: number;
}

/** Position [m] and orientation: x_world = position + orientation · x_object. */
export interface Pose {
  readonly position: Vec3;
  readonly orientation: Quat;
}

/** How an object's frame, or each of its points, moves through the world. */
export type Motion = RigidMotion | SampledPointsMotion;

/** How one frame moves through the world: of a rigid object, a light, a camera. */
export type RigidMotion = StaticMotion | UniformMotion | HyperbolicMotion | SampledMotion;

export interface StaticMotion {
  readonly kind: 'static';
  readonly pose: Pose;
}
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
 * Rigid poses at rising times. Between samples every *vertex* moves in a straight line from its place in one pose to its
 * place in the next; before the first and after the last sample it rests. Rotation is resampled so that the chord error stays small.
 */
export interface SampledMotion {
  readonly kind: 'sampled';
  /** [s], strictly rising, at least 2. */
  readonly times: Float64Array;
  /** 7 per sample: position x y z [m], orientation x y z w (unit). */
  readonly poses: Float64Array;
}
/**
 * A deforming mesh: every vertex moves between its places at rising times, in a straight line or, where velocities are given, along a cubic;
 * it rests outside them.
 */
export interface SampledPointsMotion {
  readonly kind: 'sampled-points';
  /** [s], strictly rising, at least 2. */
  readonly times: Float64Array;
  /** Where `points` are measured from [m], so that f32 holds them well. */
  readonly origin: Vec3;
  /**
   * One array per sample, 3 per vertex, world-oriented, relative to `origin` [m]; or where to find them, where they are too
   * many for memory. To be read with `pointsAt` (samplePoints.ts), which knows both.
   */
  readonly points: readonly Float32Array[] | StreamedPoints;
  /**
   * Of every vertex at each sample, world-oriented [m/s], 3 per vertex: between samples it moves along the cubic with these (Hermite), or so much of
   * it as stays slower than light (`bendFactor`). Absent where it goes straight, as all that is left in files does.
   */
  readonly velocities?: readonly Float32Array[];
  /** World-frame normals per sample, where they were given or could be computed; else from the mesh. To be read with `normalsAt`. */
  readonly normals?: readonly Float32Array[];
}
