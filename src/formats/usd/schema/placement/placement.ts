import { invert } from '../../../../math/mat3.ts';
import * as mat4 from '../../../../math/mat4.ts';
import { scale, type Vec3 } from '../../../../math/vec3.ts';
import type { StretchedMesh } from '../../../../scene/mesh/stretch.ts';
import type { Mesh, StaticMotion, UniformMotion } from '../../../../scene/types.ts';
import { stretchedMesh } from '../../../read/stretches.ts';
import type { StageContext } from '../context.ts';
import type { PlacedMesh, PrimGeometry } from '../geometry/primGeometry.ts';
import { Memo } from '../transforms/memo.ts';
import { type StageTransform, transformInMeters } from '../transforms/stageTransform.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import { placeAffine, placeBlended } from './blended.ts';
import { deformedMesh, placeDeforming, sampledPoints } from './deforming.ts';
import { boundingBoxCorners, budgetedSamples, resampledTimes, sampledPoses } from './resampling.ts';

interface MovingPlacement extends StretchedMesh {
  readonly motion: PlacedMesh['motion'] | UniformMotion;
}

interface StaticPlacement extends PlacedMesh {
  readonly motion: StaticMotion;
}

/** Relative difference below which stretches are equal: an exporter's f32 rounding. */
const STRETCH_TOLERANCE = 1e-5;

/** A constant stretch and the rigid motion of the stretched mesh. */
interface RigidPath {
  readonly stretch: readonly number[];
  readonly motion: PlacedMesh['motion'];
}

/** By frame and times. */
const RIGID_PATHS = new Memo<RigidPath | undefined>();
const STRAIGHT_PATHS = new Memo<RigidPath>();

/**
 * Places a mesh in the scene. Without time samples it is static, with its scale and shear as its stretch; if it moves
 * without changing its shape it gets sampled poses; otherwise its frame, or its joints, as blended points, or sampled points.
 */
export function placeGeometry(
  context: StageContext,
  path: string,
  shape: PrimGeometry,
  frame: StageTransform,
): PlacedMesh {
  const world = transformInMeters(frame, context.unit);
  const { deformation } = shape;
  if (deformation?.blend) return placeBlended(context, path, shape, deformation.blend, world);
  if (deformation) return placeDeforming(context, path, shape, world);
  if (world.times.length === 0) return staticPlacement(shape.mesh, world.matrixAt(context.startCode));
  if (world.isStraight) return alongPath(shape.mesh, straightPath(context, path, world));
  const times = resampledTimes(context, path, world, boundingBoxCorners(shape.mesh));
  const rigid = RIGID_PATHS.getOrCreate(world, [times], () => rigidPath(context, times, world));
  if (rigid) return alongPath(shape.mesh, rigid);
  return context.cubic
    ? sampledPoints(context, path, shape, world, times)
    : placeAffine(context, shape.mesh, world, times);
}

const alongPath = (mesh: Mesh, { stretch, motion }: RigidPath): PlacedMesh => ({
  ...stretchedMesh(mesh, stretch),
  motion,
});

/** Undefined unless the stretch is the same at all times. */
function rigidPath(context: StageContext, times: Float64Array, { matrixAt }: StageTransform): RigidPath | undefined {
  const { stretch } = mat4.decomposeRigid(matrixAt(times[0]));
  const unstretch = invert(stretch);
  const most = STRETCH_TOLERANCE * Math.max(...stretch.map(Math.abs));
  const motion = sampledPoses(context, times, (time) => {
    const m = matrixAt(time);
    const pose = unstretch && mat4.poseFromStretched(m, unstretch);
    const own = pose ? { pose, stretch } : mat4.decomposeRigid(m);
    return own.stretch.every((x, i) => Math.abs(x - stretch[i]) <= most) ? own.pose : undefined;
  });
  return motion && { stretch, motion };
}

function straightPath(context: StageContext, path: string, frame: StageTransform): RigidPath {
  const times = frame.isBudgeted ? frame.times : budgetedSamples(context, path, frame.times, frame.cost);
  context.motionBudget.record(0);
  return STRAIGHT_PATHS.getOrCreate(frame, [times], () => {
    const { pose, stretch } = mat4.decomposeRigid(frame.matrixAt(times[0]));
    const poseAt = (time: number): mat4.RigidPose => {
      const m = frame.matrixAt(time);
      return { ...pose, position: [m[3], m[7], m[11]] };
    };
    return { stretch, motion: sampledPoses(context, times, poseAt) };
  });
}

/** Places a mesh as a static one, in its state at one time code. */
export function placeAtTime(
  context: StageContext,
  shape: PrimGeometry,
  frame: StageTransform,
  time: number,
): StaticPlacement {
  const bent = shape.deformation?.at(time);
  const mesh = bent ? deformedMesh(shape.mesh, bent) : shape.mesh;
  return staticPlacement(mesh, transformInMeters(frame, context.unit).matrixAt(time));
}

/** Places a mesh that additionally moves with a constant velocity in the stage's axes [units/s]; at time 0 it is at `frame`. */
export function placeWithVelocity(
  context: StageContext,
  path: string,
  shape: PrimGeometry,
  frame: StageTransform,
  velocity: Vec3,
): MovingPlacement {
  if (frame.times.length === 0 && !shape.deformation) {
    const { motion, ...still } = placeAtTime(context, shape, frame, 0);
    return { ...still, motion: { kind: 'uniform', pose: motion.pose, velocity: scale(velocity, context.unit) } };
  }
  const carried = (time: number): mat4.Mat4 => {
    const [x, y, z] = scale(velocity, time / context.codesPerSecond);
    return mat4.multiply(mat4.fromParts([1, 0, 0, 0, 1, 0, 0, 0, 1], [x, y, z]), frame.matrixAt(time));
  };
  const times = unionOfTimes([frame.times, shape.deformation?.times ?? new Float64Array(0)]);
  return placeGeometry(context, path, shape, { times, cost: frame.cost + 1, matrixAt: (time) => carried(time ?? 0) });
}

function staticPlacement(mesh: Mesh, matrix: mat4.Mat4): StaticPlacement {
  const { pose, stretch } = mat4.decomposeRigid(matrix);
  return { ...stretchedMesh(mesh, stretch), motion: { kind: 'static', pose } };
}
