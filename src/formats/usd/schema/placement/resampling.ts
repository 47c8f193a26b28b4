import * as mat4 from '../../../../math/mat4.ts';
import { msg } from '../../../../messages/message.ts';
import { AdaptivePath, type ChordCriterion, type SampledTimes } from '../../../../scene/motion/adaptiveSampling.ts';
import type { SampledMotion, StaticMotion } from '../../../../scene/types.ts';
import { subsampleEvenly } from '../../../read/subsample.ts';
import { report } from '../../diagnostics.ts';
import type { TimeCode } from '../../layer/attributes.ts';
import type { StageContext } from '../context.ts';
import { boxCorners, transformedPoints, transformPointsInto } from '../geometry/pointSampling.ts';
import type { DeformedPoints } from '../geometry/primGeometry.ts';
import { Memo } from '../transforms/memo.ts';
import { type StageTransform, transformInMeters } from '../transforms/stageTransform.ts';

/** Tolerance for cameras and lights, which have no size: rotations in rad, paths in metres. */
const POSE_TOLERANCE = 1e-4;

/** Unit vectors of the axes, whose paths are compared with their chords. */
const AXES = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** Cost of a polar decomposition relative to a transform op. */
const POLAR_COST = 4;

/**
 * Fractions at which a path between samples is compared with its chord: irregular, so that full rotations between two
 * samples, which look like rest at the middle, are detected.
 */
const PROBE_FRACTIONS = [0.118, 0.283, 0.5, 0.691, 0.877];

/** Used if there are too many samples for all fractions. */
const MIDPOINT = [0.5];

/** Maximum number of bisections of an interval. */
const MAX_HALVINGS = 14;

/** Bounding box corners by mesh, in the prim's axes. */
const CORNERS = new WeakMap<DeformedPoints, Float64Array>();

/** The 8 corners of the bounding box, 3 numbers each. */
export function boundingBoxCorners(mesh: DeformedPoints): Float64Array {
  const corners = CORNERS.get(mesh) ?? Float64Array.from(boxCorners(mesh.positions).flat());
  CORNERS.set(mesh, corners);
  return corners;
}

export function resampledTimes(
  context: StageContext,
  path: string,
  world: StageTransform,
  corners: Float64Array,
): Float64Array {
  const about = (time: number): Float64Array =>
    transformedPoints(corners, mat4.fromParts(mat4.linearPart(world.matrixAt(time)), [0, 0, 0]));
  const size = maxOverSamples(world.times, (time) => maxDistance(about(time)));
  return resampledPoints(context, path, world, corners, context.chordTolerance * size);
}

/** Number of samples at which the size of a growing object is measured. */
const SIZE_SAMPLES = 32;

/** Maximum of `measure` over a subset of the samples that includes the first and last. */
export function maxOverSamples(samples: Float64Array, measure: (time: number) => number): number {
  let most = 0;
  for (const time of subsampleEvenly(samples, SIZE_SAMPLES)) most = Math.max(most, measure(time));
  return most;
}

/** Maximum distance of points, 3 numbers each, from the origin. */
function maxDistance(points: ArrayLike<number>): number {
  let most = 0;
  for (let i = 0; i < points.length; i += 3) most = Math.max(most, Math.hypot(points[i], points[i + 1], points[i + 2]));
  return most;
}

/** By frame and corners. */
const PATHS = new Memo<AdaptivePath>();

/** Times at which `corners` moved by the frame are sampled, to the tolerance or as the scene's budget allows. */
function resampledPoints(
  context: StageContext,
  path: string,
  frame: StageTransform,
  corners: ArrayLike<number>,
  tolerance: number,
): Float64Array {
  const samples = budgetedSamples(context, path, frame.times, frame.cost);
  const criterion = toleranceOf(context, samples, tolerance);
  const moved = new Float64Array(corners.length);
  const shape = (time: number): Float64Array => transformPointsInto(moved, corners, frame.matrixAt(time));
  const make = (): AdaptivePath => new AdaptivePath(samples, shape, criterion);
  const refined = PATHS.getOrCreate(frame, [corners, samples, criterion.fractions, tolerance], make);
  return resampledPath(context, path, refined, frame.cost, tolerance);
}

/** The samples that fit into the scene's remaining work. */
export function budgetedSamples(
  context: StageContext,
  path: string,
  written: Float64Array,
  cost: number,
): Float64Array {
  const most = context.sampleBudget.take(written.length, cost);
  if (most >= written.length) return written;
  const samples = THINNED_SAMPLES.getOrCreate(written, [most], () => subsampleEvenly(written, most));
  const message = msg`it is moved by ${written.length} samples, and all things of the scene together by more than there is room for; ${samples.length} of its samples are used (write out fewer, or move fewer things apart)`;
  report(context, 'warning', 'usd.sample-budget', path, message);
  return samples;
}

const THINNED_SAMPLES = new Memo<Float64Array>();

export function toleranceOf(context: StageContext, samples: Float64Array, tolerance: number): ChordCriterion {
  const fractions = context.sampleBudget.canProbeClosely(samples.length) ? PROBE_FRACTIONS : MIDPOINT;
  return { tolerance, fractions, maxHalvings: MAX_HALVINGS };
}

/** Sample times of a path; `cost`: of one evaluation. Reports a path that exceeds the tolerance. */
export function resampledPath(
  context: StageContext,
  path: string,
  refined: AdaptivePath,
  cost: number,
  tolerance: number,
): Float64Array {
  const found = context.motionBudget.sample(refined, cost);
  if (found.error > tolerance) reportUnfollowed(context, path, refined.samples.length, found);
  return found.times;
}

/** Reports a path with so many samples that is not followed to its tolerance. */
export function reportUnfollowed(
  context: StageContext,
  path: string,
  samples: number,
  { times, error, needed }: SampledTimes,
): void {
  const message = msg`it jumps or turns too fast between its ${samples} samples to be followed: about ${needed.toPrecision(2)} samples would be needed, ${times.length} are used, and paths are off by up to ${error.toPrecision(2)} m; write more samples, or let it turn less between them`;
  report(context, 'warning', 'usd.resampling', path, message, { off: error });
}

/**
 * The poses at some time codes as a motion, static if all are equal; undefined if `poseAt` is undefined at one of them. Signs
 * of neighbouring quaternions agree.
 */
export function sampledPoses<P extends mat4.RigidPose | undefined>(
  context: Pick<StageContext, 'codesPerSecond'>,
  times: Float64Array,
  poseAt: (time: number) => P,
): StaticMotion | SampledMotion | Extract<P, undefined> {
  const poses = new Float64Array(times.length * 7);
  let first: mat4.RigidPose | undefined;
  for (let i = 0; i < times.length; i++) {
    const pose = poseAt(times[i]);
    if (!pose) return undefined as Extract<P, undefined>;
    first ??= pose;
    setPose(poses, i, pose);
  }
  const moves = poses.some((x, i) => x !== poses[i % 7]);
  if (!moves || times.length < 2) return { kind: 'static', pose: first! };
  return { kind: 'sampled', times: times.map((t) => t / context.codesPerSecond), poses };
}

function setPose(poses: Float64Array, i: number, { position, orientation }: mat4.RigidPose): void {
  const at = 7 * i;
  let cosine = 0;
  for (let k = 0; k < 4; k++) cosine += orientation[k] * (i > 0 ? poses[at - 4 + k] : orientation[k]);
  for (let k = 0; k < 3; k++) poses[at + k] = position[k];
  for (let k = 0; k < 4; k++) poses[at + 3 + k] = cosine < 0 ? -orientation[k] : orientation[k];
}

/** Frames without their stretch. */
const RIGID_TRANSFORMS = new Memo<StageTransform>();
const RIGID_MOTIONS = new Memo<StaticMotion | SampledMotion>();

/** Motion of a camera's or light's axes; their scale is ignored. */
export function rigidMotionOf(
  context: StageContext,
  path: string,
  frame: StageTransform,
): StaticMotion | SampledMotion {
  const world = transformInMeters(frame, context.unit);
  const { times, cost } = world;
  const poseAt = (time: number): mat4.RigidPose => mat4.decomposeRigid(world.matrixAt(time)).pose;
  if (times.length === 0) return { kind: 'static', pose: poseAt(context.startCode) };
  const matrixAt = (time: TimeCode): mat4.Mat4 => mat4.fromPose(poseAt(time ?? 0));
  const rigid = RIGID_TRANSFORMS.getOrCreate(world, [], () => ({ times, cost: cost + POLAR_COST, matrixAt }));
  const found = resampledPoints(context, path, rigid, AXES, POSE_TOLERANCE);
  return RIGID_MOTIONS.getOrCreate(world, [found], () => sampledPoses(context, found, poseAt));
}
