import { type Mat3, transpose } from '../../../math/mat3.ts';
import { rotate, slerp, toMatrix } from '../../../math/quat.ts';
import { add, lerp, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { contraction } from '../../../physics/worldLines/simultaneity.ts';
import type { WorldLine } from '../../../physics/worldLines/worldLine.ts';
import { deformedNormals, smoothingGroups } from '../../mesh/normals.ts';
import { bakedObject, objectPoint } from '../../mesh/stretch.ts';
import type { Pose, SampledMotion, SampledPointsMotion, SceneObject } from '../../types.ts';
import { almostC, seconds, validateFastest } from '../../validation/motionFindings.ts';
import { applyPose, mapPoses, pieceAt, samplePose } from '../poses.ts';
import { composePoses, flyPose, toWorldTime, transformPose } from './changes.ts';
import { fastestOfPoints } from './fastestPoints.ts';
import { fastestOfPoses } from './fastestPoses.ts';
import type { FastestVertex, ObjectWith, RigidMotionKind } from './motionKind.ts';
import { ofAffineMap, placeVertices } from './rigidMotion.ts';

function poseAt({ times, poses }: SampledMotion, t: number): Pose {
  const { before, after, s } = pieceAt(times, t);
  const [a, b] = [samplePose(poses, before), samplePose(poses, after)];
  return { position: lerp(a.position, b.position, s), orientation: slerp(a.orientation, b.orientation, s) };
}

/** The world line through a place at each sample. */
function lineThrough(motion: SampledMotion, placeAt: (k: number) => Vec3): WorldLine {
  const positions = new Float64Array(3 * motion.times.length);
  for (let k = 0; k < motion.times.length; k++) positions.set(placeAt(k), 3 * k);
  return { kind: 'polyline', times: motion.times, positions };
}

/** Place in the world at sample k of a point of the object, contracted if a speed of light is given [m/s]. */
function placeAtSample(motion: SampledMotion, k: number, contractedFor: number | undefined): (x: Vec3) => Vec3 {
  const pose = samplePose(motion.poses, k);
  if (contractedFor === undefined) return (x) => applyPose(pose, x);
  const u = sampleVelocity(motion, k, contractedFor);
  return (x) => add(pose.position, contraction(rotate(pose.orientation, x), u));
}

/** Where sample k places the object's axes: x → position + M x, contracted if it is authored in its rest frame. c [m/s]. */
export function frameAtSample(
  { motion, authoredIn }: ObjectWith<SampledMotion>,
  k: number,
  c: number,
): { readonly position: Vec3; readonly linear: Mat3 } {
  const { position, orientation } = samplePose(motion.poses, k);
  const turn = toMatrix(orientation);
  if (authoredIn === 'world') return { position, linear: turn };
  const u = sampleVelocity(motion, k, c);
  const columns = transpose(turn);
  const shortened = [0, 3, 6].flatMap((i) => contraction([columns[i], columns[i + 1], columns[i + 2]], u));
  return { position, linear: transpose(shortened) };
}

/**
 * The frame's proper velocity at sample k, in units of c: the mean over the two pieces that meet there, or that of the only one. It
 * contracts what is authored in the rest frame; accelerations are taken as small over the body (docs/model.md).
 */
function sampleVelocity({ times, poses }: SampledMotion, k: number, c: number): Vec3 {
  const [a, b] = [Math.max(0, k - 1), Math.min(times.length - 1, k + 1)];
  const moved = sub(samplePose(poses, b).position, samplePose(poses, a).position);
  return properVelocity(scale(moved, 1 / (c * (times[b] - times[a]))));
}

function vertexPlacer(object: ObjectWith<SampledMotion>, t: number, c: number) {
  const { motion, authoredIn } = object;
  const { before, after, s } = pieceAt(motion.times, t);
  const contractedFor = authoredIn === 'rest' ? c : undefined;
  const [a, b] = [before, after].map((k) => placeAtSample(motion, k, contractedFor));
  return (i: number): Vec3 => {
    const x = objectPoint(object, i);
    return lerp(a(x), b(x), s);
  };
}

/**
 * A sampled motion authored in the rest frame, as points of the world: at each sample the body is contracted along its
 * frame's velocity there.
 */
function contractedPoints(object: ObjectWith<SampledMotion>, c: number): SampledPointsMotion {
  const { mesh, motion } = object;
  const origin = samplePose(motion.poses, 0).position;
  const points = Array.from(motion.times, (t) =>
    Float32Array.from(placeVertices(mesh, vertexPlacer(object, t, c)), (x, i) => x - origin[i % 3]),
  );
  const groups = smoothingGroups(mesh);
  const normals = points.map((p) => deformedNormals(p, mesh.indices, groups));
  return { kind: 'sampled-points', times: motion.times, origin, points, normals };
}

function restToWorld(object: ObjectWith<SampledMotion>, c: number): SceneObject {
  if (object.authoredIn !== 'rest') return object;
  const baked = bakedObject(object);
  return { ...baked, authoredIn: 'world', motion: contractedPoints(baked, c) };
}

const ORIGIN = { positions: new Float32Array(3) };

/** If the frame itself reaches c, there is no contraction, and the speed of the frame is returned. */
function fastestVertex(object: ObjectWith<SampledMotion>, c: number, atLeast: number): FastestVertex {
  const { motion } = object;
  if (object.authoredIn !== 'rest') return fastestOfPoses(object, motion, atLeast);
  const frame = fastestOfPoses({ mesh: ORIGIN }, motion, 0);
  return frame.speed < c ? fastestOfPoints(contractedPoints(bakedObject(object), c), c, atLeast) : frame;
}

function nonFiniteText({ times, poses }: SampledMotion): Message | undefined {
  const at = poses.findIndex((x) => !Number.isFinite(x));
  return at < 0 ? undefined : msg`the pose at ${seconds(times[Math.floor(at / 7)])} has ${poses[at]} in it`;
}

export const SAMPLED_MOTION: RigidMotionKind<SampledMotion> = {
  isStatic: false,
  deforms: false,
  approachesC: false,
  restingPose: () => undefined,
  fixedOrientation: () => undefined,
  sampleTimes: ({ times }) => times,
  sampleCount: ({ poses }) => poses.length / 7,
  poseSamples: (motion) => motion,
  pointSamples: () => undefined,
  numbers: ({ times, poses }) => [times, poses],
  poseAt,
  originWorldLine: (motion) => lineThrough(motion, (k) => samplePose(motion.poses, k).position),
  vertexWorldLine: (object, i, c) => {
    const { motion, authoredIn } = object;
    const x = objectPoint(object, i);
    return lineThrough(motion, (k) => placeAtSample(motion, k, authoredIn === 'rest' ? c : undefined)(x));
  },
  vertexPlacer,
  ...ofAffineMap(vertexPlacer),
  fastestVertex: (object, c, _range, atLeast) => fastestVertex(object, c, atLeast),
  keepsFastest: () => false,
  restToWorld,
  nonFiniteText,
  validateSpeed: (object, c) => validateFastest(object.path, fastestVertex(object, c, almostC(c)), c),
  retime: (motion, map) => ({ ...motion, times: motion.times.map((t) => toWorldTime(t, map)) }),
  transform: (motion, by) => ({ ...motion, poses: mapPoses(motion.poses, (pose) => transformPose(pose, by)) }),
  compose: (frame, pose) => ({ ...frame, poses: mapPoses(frame.poses, (each) => composePoses(each, pose)) }),
  fly: (motion, path) => flyPose(poseAt(motion, path.at), path),
};
