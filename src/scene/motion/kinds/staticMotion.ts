import type { WorldLine } from '../../../physics/worldLines/worldLine.ts';
import { objectPoint } from '../../mesh/stretch.ts';
import type { StaticMotion } from '../../types.ts';
import { applyPose } from '../poses.ts';
import { flyPose, transformPose } from './changes.ts';
import { type ObjectWith, REST, type RigidMotionKind } from './motionKind.ts';
import { nonFinitePoseText, ofAffineMap, POSED, placeByWorldLine, poseNumbers } from './rigidMotion.ts';

const vertexWorldLine = (object: ObjectWith<StaticMotion>, i: number): WorldLine => ({
  kind: 'static',
  position: applyPose(object.motion.pose, objectPoint(object, i)),
});

const vertexPlacer = placeByWorldLine(vertexWorldLine);

export const STATIC_MOTION: RigidMotionKind<StaticMotion> = {
  ...POSED,
  isStatic: true,
  approachesC: false,
  restingPose: ({ pose }) => pose,
  numbers: (motion) => [poseNumbers(motion)],
  poseAt: ({ pose }) => pose,
  originWorldLine: ({ pose }) => ({ kind: 'static', position: pose.position }),
  vertexWorldLine,
  vertexPlacer,
  ...ofAffineMap(vertexPlacer),
  fastestVertex: () => REST,
  nonFiniteText: (motion) => nonFinitePoseText(motion, [0, 0, 0]),
  validateSpeed: () => [],
  retime: (motion) => motion,
  transform: (motion, by) => ({ ...motion, pose: transformPose(motion.pose, by) }),
  fly: ({ pose }, path) => flyPose(pose, path),
};
