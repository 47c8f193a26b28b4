import { IDENTITY, type Quat, rotate, slerp } from '../../math/quat.ts';
import { add, dot, lerp, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { cubicAt, withBend } from '../../physics/worldLines/cubicPiece.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import { type CubicLine, positionAt, samplesUntil, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import { pointAt } from '../mesh/polygons.ts';
import { pointsAt, vertexAt } from '../streaming/samplePoints.ts';
import type {
  HyperbolicMotion,
  Motion,
  Pose,
  RigidMotion,
  SampledMotion,
  SampledPointsMotion,
  SceneObject,
} from '../types.ts';
import { bendFactor, type CubicPointsMotion, isCubic, pointPiece } from './cubicPoints.ts';

/** Sample i of rigid poses. */
export function samplePose(poses: ArrayLike<number>, i: number): Pose {
  const k = 7 * i;
  const orientation: Quat = [poses[k + 3], poses[k + 4], poses[k + 5], poses[k + 6]];
  return { position: [poses[k], poses[k + 1], poses[k + 2]], orientation };
}

/** x_world = position + orientation · x */
export const applyPose = (pose: Pose, x: Vec3): Vec3 => add(pose.position, rotate(pose.orientation, x));

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
      return { ...motion.pose, position: positionAt(originWorldLine(motion), t, c) };
    case 'sampled':
      return sampledPose(motion, t);
    case 'sampled-points':
      return { position: motion.origin, orientation: IDENTITY };
  }
}

function sampledPose({ times, poses }: SampledMotion, t: number): Pose {
  const { before, after, s } = pieceAt(times, t);
  const [a, b] = [samplePose(poses, before), samplePose(poses, after)];
  return { position: lerp(a.position, b.position, s), orientation: slerp(a.orientation, b.orientation, s) };
}

/** The samples round t and the share of the way from one to the other; outside all samples the nearest one, twice. */
export function pieceAt(times: Float64Array, t: number): { before: number; after: number; s: number } {
  const i = samplesUntil(times, t);
  if (i === 0 || i === times.length) return { before: Math.max(0, i - 1), after: Math.max(0, i - 1), s: 0 };
  return { before: i - 1, after: i, s: (t - times[i - 1]) / (times[i] - times[i - 1]) };
}

/** The world line of the origin of the object's frame. */
export function originWorldLine(motion: RigidMotion): WorldLine {
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
      return { kind: 'static', position: applyPose(motion.pose, x) };
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
      if (isCubic(motion)) return cubicVertex(motion, i, c);
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
  for (let k = 0; k < motion.times.length; k++) out.set(placeAtSample(motion, k, contractedFor)(x), 3 * k);
  return out;
}

/** Where a point of the object is in the world at sample k; contracted for the speed of light that is given [m/s]. */
function placeAtSample(motion: SampledMotion, k: number, contractedFor: number | undefined): (x: Vec3) => Vec3 {
  const pose = samplePose(motion.poses, k);
  if (contractedFor === undefined) return (x) => applyPose(pose, x);
  const u = sampleVelocity(motion, k, contractedFor);
  return (x) => add(pose.position, contraction(rotate(pose.orientation, x), u));
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

function deformingVertex(motion: SampledPointsMotion, i: number): Float64Array {
  const out = new Float64Array(3 * motion.times.length);
  for (let k = 0; k < motion.times.length; k++) out.set(add(motion.origin, vertexAt(motion, k, i)), 3 * k);
  return out;
}

function cubicVertex(motion: CubicPointsMotion, i: number, c: number): CubicLine {
  const { times } = motion;
  const velocities = new Float64Array(6 * (times.length - 1));
  for (let k = 0; k + 1 < times.length; k++) {
    const { va, vb } = withBend(pointPiece(motion, k, i), bendFactor(motion, k, c));
    velocities.set([...va, ...vb], 6 * k);
  }
  return { kind: 'cubic', times, positions: deformingVertex(motion, i), velocities };
}

/** Vertex i in the world frame at world time t [m]. */
export const vertexPosition = (object: SceneObject, i: number, t: number, c: number): Vec3 =>
  positionAt(vertexWorldLine(object, i, c), t, c);

/** All vertices in the world frame at world time t, 3 numbers each [m]: as `vertexPosition`, without whole world lines. */
export function vertexPositions(object: SceneObject, t: number, c: number): Float64Array {
  const out = new Float64Array(object.mesh.positions.length);
  const at = vertexPlacer(object, t, c);
  for (let i = 0; 3 * i < out.length; i++) out.set(at(i), 3 * i);
  return out;
}

/** Vertex → place at t; what the vertices share is worked out once. */
function vertexPlacer(object: SceneObject, t: number, c: number): (vertex: number) => Vec3 {
  const { motion, mesh } = object;
  if (motion.kind === 'sampled') {
    const { before, after, s } = pieceAt(motion.times, t);
    const contractedFor = object.authoredIn === 'rest' ? c : undefined;
    const [a, b] = [before, after].map((k) => placeAtSample(motion, k, contractedFor));
    return (i) => lerp(a(pointAt(mesh.positions, i)), b(pointAt(mesh.positions, i)), s);
  }
  if (motion.kind === 'sampled-points') {
    const at = deformedPoints(motion, t, c);
    return (i) => add(motion.origin, at(i));
  }
  return (i) => vertexPosition(object, i, t, c);
}

/** Vertex → its place at world time t, from the motion's origin. c [m/s]. */
export function deformedPoints(motion: SampledPointsMotion, t: number, c: number): (vertex: number) => Vec3 {
  const { before, after, s } = pieceAt(motion.times, t);
  const [a, b] = [pointsAt(motion, before), pointsAt(motion, after)];
  if (!isCubic(motion) || before === after) return (i) => lerp(pointAt(a, i), pointAt(b, i), s);
  const bend = bendFactor(motion, before, c);
  const since = t - motion.times[before];
  return (i) => cubicAt(withBend(pointPiece(motion, before, i), bend), since).x;
}
