import * as mat4 from '../../math/mat4.ts';
import { type Closeness, RefinedPath } from '../../scene/refine.ts';
import type { SampledMotion, StaticMotion } from '../../scene/types.ts';
import { evenly } from '../evenly.ts';
import type { TimeCode } from './attributes.ts';
import { report, type StageContext } from './context.ts';
import { type Frame, scaledFrame } from './frame.ts';
import { Once } from './once.ts';
import { boxCorners, carried, carriedInto } from './sampling.ts';
import type { DeformedPoints } from './shape.ts';

/** Turns between samples of what has no size are followed to this angle [rad], paths to as many metres. */
const FRAME_TOLERANCE = 1e-4;

/** Tips of the axes: they turn by at most the tolerance against the chord. */
const AXES = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** A polar decomposition takes as long as so many ops. */
const POLAR_COST = 4;

/**
 * Where a path between samples is compared with its chord: at irregular fractions, so that whole turns between two
 * samples (which look like rest at the half) are found.
 */
const LOOKS = [0.118, 0.283, 0.5, 0.691, 0.877];

/** Where there are more samples than can be looked at so closely. */
const MIDDLE = [0.5];

/** One interval is halved at most this often. */
const MAX_HALVINGS = 14;

/** Of each shape in its prim's axes. */
const CORNERS = new WeakMap<DeformedPoints, Float64Array>();

/** 3 numbers for each corner of the box around it. */
export function cornersOf(mesh: DeformedPoints): Float64Array {
  const corners = CORNERS.get(mesh) ?? Float64Array.from(boxCorners(mesh.positions).flat());
  CORNERS.set(mesh, corners);
  return corners;
}

export function refined(context: StageContext, path: string, world: Frame, corners: Float64Array): Float64Array {
  const about = (time: number): Float64Array =>
    carried(corners, mat4.fromParts(mat4.linearPart(world.matrixAt(time)), [0, 0, 0]));
  const size = greatest(world.times, (time) => farthest(about(time)));
  return followed(context, path, world, corners, context.chordTolerance * size);
}

/** The size of what grows is looked for at so many of its samples. */
const SIZE_SAMPLES = 32;

/** The greatest of what is measured at some samples, the first and the last among them. */
export function greatest(samples: Float64Array, measure: (time: number) => number): number {
  let most = 0;
  for (const time of evenly(samples, SIZE_SAMPLES)) most = Math.max(most, measure(time));
  return most;
}

/** Distance of the farthest of some points, 3 numbers each, from the origin. */
function farthest(points: ArrayLike<number>): number {
  let most = 0;
  for (let i = 0; i < points.length; i += 3) most = Math.max(most, Math.hypot(points[i], points[i + 1], points[i + 2]));
  return most;
}

/** What is in one frame and has the same corners goes along one path. */
const PATHS = new Once<RefinedPath>();

/** Times at which `corners` are followed along the frame's path, as closely as the scene's budget allows. */
function followed(
  context: StageContext,
  path: string,
  frame: Frame,
  corners: ArrayLike<number>,
  tolerance: number,
): Float64Array {
  const samples = affordedSamples(context, path, frame.times, frame.cost);
  const closeness = closenessOf(context, samples, tolerance);
  const there = new Float64Array(corners.length);
  const shape = (time: number): Float64Array => carriedInto(there, corners, frame.matrixAt(time));
  const make = (): RefinedPath => new RefinedPath(samples, shape, closeness);
  const refined = PATHS.of(frame, [corners, samples, closeness.looks, tolerance], make);
  return followedPath(context, path, refined, frame.cost, tolerance);
}

/** The samples that the scene still has time for. */
export function affordedSamples(
  context: StageContext,
  path: string,
  written: Float64Array,
  cost: number,
): Float64Array {
  const most = context.sampleBudget.take(written.length, cost);
  if (most >= written.length) return written;
  const samples = THINNED.of(written, [most], () => evenly(written, most));
  const message = `it is moved by ${written.length} samples, and all things of the scene together by more than there is room for; ${samples.length} of its samples are used (write out fewer, or move fewer things apart)`;
  report(context, 'warning', 'usd.sample-budget', path, message);
  return samples;
}

const THINNED = new Once<Float64Array>();

export function closenessOf(context: StageContext, samples: Float64Array, tolerance: number): Closeness {
  const looks = context.sampleBudget.looksClosely(samples.length) ? LOOKS : MIDDLE;
  return { tolerance, looks, halvings: MAX_HALVINGS };
}

/** Times along a path; `cost`: of where its points are at one time. */
export function followedPath(
  context: StageContext,
  path: string,
  refined: RefinedPath,
  cost: number,
  tolerance: number,
): Float64Array {
  const { times, error, wanted } = context.motionBudget.refine(refined, cost);
  if (error > tolerance) {
    const message = `it jumps or turns too fast between its ${refined.samples.length} samples to be followed: about ${wanted.toPrecision(2)} samples would be needed, ${times.length} are used, and paths are off by up to ${error.toPrecision(2)} m; write more samples, or let it turn less between them`;
    report(context, 'warning', 'usd.resampling', path, message);
  }
  return times;
}

/**
 * The pose at each of some times [codes] as one motion, static where they are all the same; undefined where one of them has
 * none. The signs of neighbouring quaternions agree.
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
const RIGID = new Once<Frame>();
const MOTIONS = new Once<StaticMotion | SampledMotion>();

/** How a prim's own axes move: of a camera or a light, which have no size. Their scale does not matter. */
export function frameMotion(context: StageContext, path: string, frame: Frame): StaticMotion | SampledMotion {
  const world = scaledFrame(frame, context.unit);
  const { times, cost } = world;
  const poseAt = (time: number): mat4.RigidPose => mat4.decomposeRigid(world.matrixAt(time)).pose;
  if (times.length === 0) return { kind: 'static', pose: poseAt(context.startCode) };
  const matrixAt = (time: TimeCode): mat4.Mat4 => mat4.fromPose(poseAt(time ?? 0));
  const rigid = RIGID.of(world, [], () => ({ times, cost: cost + POLAR_COST, matrixAt }));
  const found = followed(context, path, rigid, AXES, FRAME_TOLERANCE);
  return MOTIONS.of(world, [found], () => sampledPoses(context, found, poseAt));
}
