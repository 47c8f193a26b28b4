import { IDENTITY, type Quat, rotate, slerp } from '../math/quat.ts';
import { add, dot, lerp, scale, sub, type Vec3 } from '../math/vec3.ts';
import { properVelocity } from '../physics/boost.ts';
import { contraction } from '../physics/simultaneity.ts';
import { positionAt, samplesUntil, type WorldLine } from '../physics/worldLine.ts';
import { pointAt } from './polygons.ts';
import type { HyperbolicMotion, Motion, Pose, SampledMotion, SampledPointsMotion, SceneObject } from './types.ts';

/** Sample i of rigid poses. */
export function samplePose(poses: ArrayLike<number>, i: number): Pose {
  const k = 7 * i;
  const orientation: Quat = [poses[k + 3], poses[k + 4], poses[k + 5], poses[k + 6]];
  return { position: [poses[k], poses[k + 1], poses[k + 2]], orientation };
}

/** x_world = position + orientation · x */
export const placed = (pose: Pose, x: Vec3): Vec3 => add(pose.position, rotate(pose.orientation, x));

/**
 * The object's frame at world time t [s]; c [m/s]. Between samples the position goes straight and the orientation turns
 * evenly; a deforming object has its origin, not turned.
 */
export function poseAt(motion: Motion, t: number, c: number): Pose {
  switch (motion.kind) {
    case 'static':
      return motion.pose;
    case 'uniform':
    case 'hyperbolic':
      return { ...motion.pose, position: positionAt(originLine(motion), t, c) };
    case 'sampled':
      return sampledPose(motion, t);
    case 'sampled-points':
      return { position: motion.origin, orientation: IDENTITY };
  }
}

function sampledPose({ times, poses }: SampledMotion, t: number): Pose {
  const i = samplesUntil(times, t);
  if (i === 0 || i === times.length) return samplePose(poses, Math.max(0, i - 1));
  const [a, b] = [samplePose(poses, i - 1), samplePose(poses, i)];
  const s = (t - times[i - 1]) / (times[i] - times[i - 1]);
  return { position: lerp(a.position, b.position, s), orientation: slerp(a.orientation, b.orientation, s) };
}

/** The world line of the origin of the object's frame. */
export function originLine(motion: Exclude<Motion, SampledPointsMotion>): WorldLine {
  switch (motion.kind) {
    case 'static':
      return { kind: 'static', position: motion.pose.position };
    case 'uniform':
      return { kind: 'uniform', position: motion.pose.position, velocity: motion.velocity };
    case 'hyperbolic':
      return { ...motion, position: motion.pose.position };
    case 'sampled': {
      const positions = new Float64Array(3 * motion.times.length);
      for (let i = 0; i < motion.times.length; i++) positions.set(samplePose(motion.poses, i).position, 3 * i);
      return { kind: 'polyline', times: motion.times, positions };
    }
  }
}

/**
 * The world line of vertex i. A mesh authored in its rest frame is contracted along its velocity; in hyperbolic motion
 * it is Born rigid, so each vertex has its own acceleration. c [m/s].
 */
export function vertexWorldLine(object: SceneObject, i: number, c: number): WorldLine {
  const { motion } = object;
  const x = pointAt(object.mesh.positions, i);
  const rest = object.authoredIn === 'rest';
  switch (motion.kind) {
    case 'static':
      return { kind: 'static', position: placed(motion.pose, x) };
    case 'uniform': {
      const o = rotate(motion.pose.orientation, x);
      const offset = rest ? contraction(o, properVelocity(scale(motion.velocity, 1 / c))) : o;
      return { kind: 'uniform', position: add(motion.pose.position, offset), velocity: motion.velocity };
    }
    case 'hyperbolic': {
      const o = rotate(motion.pose.orientation, x);
      const { t0 } = motion;
      const properAcceleration = rest ? bornRigidAcceleration(motion, o, c) : motion.properAcceleration;
      return { kind: 'hyperbolic', position: add(motion.pose.position, o), properAcceleration, t0 };
    }
    case 'sampled':
      return { kind: 'polyline', times: motion.times, positions: sampledVertex(motion, x, rest ? c : undefined) };
    case 'sampled-points':
      return { kind: 'polyline', times: motion.times, positions: deformingVertex(motion, i) };
  }
}

/**
 * a/(1 + a·o/c²): all points of a Born-rigid body share one horizon, c²/a behind its origin. o [m]: from the origin, in
 * the frame in which the body is at rest at t0. Source: Rindler, Relativity, §3.8.
 */
export const bornRigidAcceleration = (motion: HyperbolicMotion, o: Vec3, c: number): Vec3 =>
  scale(motion.properAcceleration, 1 / (1 + dot(motion.properAcceleration, o) / (c * c)));

function sampledVertex(motion: SampledMotion, x: Vec3, contractedFor: number | undefined): Float64Array {
  const out = new Float64Array(3 * motion.times.length);
  for (let k = 0; k < motion.times.length; k++) {
    const pose = samplePose(motion.poses, k);
    const o = rotate(pose.orientation, x);
    const offset = contractedFor === undefined ? o : contraction(o, sampleVelocity(motion, k, contractedFor));
    out.set(add(pose.position, offset), 3 * k);
  }
  return out;
}

/**
 * The frame's proper velocity at sample k, in units of c: over the two pieces that meet there, or the one at an end. It
 * contracts what is authored in its rest frame; accelerations are taken as small over the body (docs/model.md).
 */
export function sampleVelocity({ times, poses }: SampledMotion, k: number, c: number): Vec3 {
  const [a, b] = [Math.max(0, k - 1), Math.min(times.length - 1, k + 1)];
  const moved = sub(samplePose(poses, b).position, samplePose(poses, a).position);
  return properVelocity(scale(moved, 1 / (c * (times[b] - times[a]))));
}

function deformingVertex({ points, origin }: SampledPointsMotion, i: number): Float64Array {
  const out = new Float64Array(3 * points.length);
  for (let k = 0; k < points.length; k++) out.set(add(origin, pointAt(points[k], i)), 3 * k);
  return out;
}

/** Vertex i in the world frame at world time t [m]. */
export const vertexPosition = (object: SceneObject, i: number, t: number, c: number): Vec3 =>
  positionAt(vertexWorldLine(object, i, c), t, c);
