import { rotate } from '../../../math/quat.ts';
import { add, dot, length, scale, type Vec3 } from '../../../math/vec3.ts';
import { msg } from '../../../messages/message.ts';
import { positionAt, velocityAt, type WorldLine } from '../../../physics/worldLines/worldLine.ts';
import { objectPoint } from '../../mesh/stretch.ts';
import type { Diagnostic, HyperbolicMotion, Pose } from '../../types.ts';
import { motionPlace, problem, roundedUp } from '../../validation/motionFindings.ts';
import { flyPose, toWorldTime, transformPose, transformVelocity } from './changes.ts';
import { type FastestVertex, type ObjectWith, REST, type RigidMotionKind } from './motionKind.ts';
import { nonFinitePoseText, ofVertices, POSED, placeByWorldLine, poseNumbers } from './rigidMotion.ts';

const originWorldLine = (motion: HyperbolicMotion): WorldLine => ({ ...motion, position: motion.pose.position });

const poseAt = (motion: HyperbolicMotion, t: number, c: number): Pose => ({
  ...motion.pose,
  position: positionAt(originWorldLine(motion), t, c),
});

/**
 * a/(1 + a·o/c²): all points of a Born-rigid body share one horizon, c²/a behind its origin. o [m]: from the origin, in
 * the frame in which the body is at rest at t0. Source: Rindler, Relativity, §3.8.
 */
export const bornRigidAcceleration = (motion: HyperbolicMotion, o: Vec3, c: number): Vec3 =>
  scale(motion.properAcceleration, 1 / (1 + dot(motion.properAcceleration, o) / (c * c)));

/** A mesh authored in its rest frame is Born rigid, so each vertex has its own acceleration. */
function vertexWorldLine(object: ObjectWith<HyperbolicMotion>, i: number, c: number): WorldLine {
  const { motion, authoredIn } = object;
  const o = rotate(motion.pose.orientation, objectPoint(object, i));
  const { t0 } = motion;
  const properAcceleration = authoredIn === 'rest' ? bornRigidAcceleration(motion, o, c) : motion.properAcceleration;
  return { kind: 'hyperbolic', position: add(motion.pose.position, o), properAcceleration, t0 };
}

const vertexPlacer = placeByWorldLine(vertexWorldLine);

/** It has no greatest speed: it is evaluated at the ends of `range` [s]. */
function fastestVertex(
  object: ObjectWith<HyperbolicMotion>,
  c: number,
  range: readonly [number, number],
): FastestVertex {
  let best = REST;
  for (let i = 0; i < object.mesh.positions.length / 3; i++) {
    const line = vertexWorldLine(object, i, c);
    for (const t of range) {
      const speed = length(velocityAt(line, t, c));
      if (speed > best.speed) best = { speed, vertex: i, from: t, to: t };
    }
  }
  return best;
}

/** All of a Born-rigid body must be in front of its horizon, c²/a behind the origin of its frame. */
function validateHorizon(object: ObjectWith<HyperbolicMotion>, c: number): Diagnostic[] {
  const { path, mesh, authoredIn, motion } = object;
  if (authoredIn !== 'rest') return [];
  const a = motion.properAcceleration;
  let depth = 0;
  for (let i = 0; i < mesh.positions.length / 3; i++) {
    depth = Math.max(depth, -dot(a, rotate(motion.pose.orientation, objectPoint(object, i))));
  }
  if (depth < c * c) return [];
  const [behind, horizon] = [depth, c * c].map((of) => (of / length(a)).toPrecision(3));
  const message = msg`a point ${behind} m behind its origin would have to outrun light (horizon at ${horizon} m); raise c above ${roundedUp(Math.sqrt(depth))} m/s or accelerate less`;
  return [problem('error', 'motion.horizon', motionPlace(path), message)];
}

export const HYPERBOLIC_MOTION: RigidMotionKind<HyperbolicMotion> = {
  ...POSED,
  isStatic: false,
  approachesC: true,
  restingPose: () => undefined,
  numbers: (motion) => [poseNumbers(motion), [...motion.properAcceleration, motion.t0]],
  poseAt,
  originWorldLine,
  vertexWorldLine,
  vertexPlacer,
  ...ofVertices(vertexPlacer),
  fastestVertex,
  nonFiniteText: (motion) => nonFinitePoseText(motion, motion.properAcceleration),
  validateSpeed: validateHorizon,
  retime: (motion, map) => ({
    ...motion,
    properAcceleration: scale(motion.properAcceleration, 1 / (map.a * map.a)),
    t0: toWorldTime(motion.t0, map),
  }),
  transform: (motion, by) => ({
    ...motion,
    pose: transformPose(motion.pose, by),
    properAcceleration: transformVelocity(motion.properAcceleration, by),
  }),
  fly: (motion, path) => flyPose(poseAt(motion, path.at, path.c), path),
};
