import { rotate } from '../../../math/quat.ts';
import { add, addScaled, length, scale } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { contraction } from '../../../physics/worldLines/simultaneity.ts';
import { positionAt, type WorldLine } from '../../../physics/worldLines/worldLine.ts';
import { objectPoint } from '../../mesh/stretch.ts';
import type { Pose, UniformMotion } from '../../types.ts';
import { validateFastest } from '../../validation/motionFindings.ts';
import { flyPose, transformPose, transformVelocity } from './changes.ts';
import { type ObjectWith, REST, type RigidMotionKind } from './motionKind.ts';
import { nonFinitePoseText, ofAffineMap, POSED, placeByWorldLine, poseNumbers } from './rigidMotion.ts';

const originWorldLine = ({ pose, velocity }: UniformMotion): WorldLine => ({
  kind: 'uniform',
  position: pose.position,
  velocity,
});

const poseAt = (motion: UniformMotion, t: number, c: number): Pose => ({
  ...motion.pose,
  position: positionAt(originWorldLine(motion), t, c),
});

/** A mesh authored in its rest frame is contracted along its velocity. */
function vertexWorldLine(object: ObjectWith<UniformMotion>, i: number, c: number): WorldLine {
  const { motion, authoredIn } = object;
  const o = rotate(motion.pose.orientation, objectPoint(object, i));
  const offset = authoredIn === 'rest' ? contraction(o, properVelocity(scale(motion.velocity, 1 / c))) : o;
  return { kind: 'uniform', position: add(motion.pose.position, offset), velocity: motion.velocity };
}

const vertexPlacer = placeByWorldLine(vertexWorldLine);

export const UNIFORM_MOTION: RigidMotionKind<UniformMotion> = {
  ...POSED,
  isStatic: false,
  approachesC: false,
  restingPose: () => undefined,
  numbers: (motion) => [poseNumbers(motion), motion.velocity],
  poseAt,
  originWorldLine,
  vertexWorldLine,
  vertexPlacer,
  ...ofAffineMap(vertexPlacer),
  fastestVertex: ({ motion }) => ({ ...REST, speed: length(motion.velocity) }),
  nonFiniteText: (motion) => nonFinitePoseText(motion, motion.velocity),
  validateSpeed: ({ path, motion }, c) => validateFastest(path, { ...REST, speed: length(motion.velocity) }, c),
  retime: (motion, { a, b }) => {
    // x + v τ with τ = (t − b)/a.
    const velocity = scale(motion.velocity, 1 / a);
    return { ...motion, velocity, pose: { ...motion.pose, position: addScaled(motion.pose.position, velocity, -b) } };
  },
  transform: (motion, by) => ({
    ...motion,
    pose: transformPose(motion.pose, by),
    velocity: transformVelocity(motion.velocity, by),
  }),
  fly: (motion, path) => flyPose(poseAt(motion, path.at, path.c), path),
};
