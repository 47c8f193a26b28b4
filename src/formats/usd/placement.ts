import { hermite } from '../../math/hermite.ts';
import { determinant, invert } from '../../math/mat3.ts';
import * as mat4 from '../../math/mat4.ts';
import { distance, scale, type Vec3 } from '../../math/vec3.ts';
import { chordGap, parabolaVelocities, parabolaVelocityAt } from '../../scene/cubicPoints.ts';
import { gatherPoints } from '../../scene/geometry.ts';
import { transformMesh } from '../../scene/meshOps.ts';
import { pieceAt } from '../../scene/motion.ts';
import { deformedNormals, smoothingGroups } from '../../scene/normals.ts';
import { surveyPoints } from '../../scene/pointFacts.ts';
import { readSample, type StoredSample } from '../../scene/storedNumbers.ts';
import { makeNormals, makePoints, type PointRecipe } from '../../scene/streamedPoints.ts';
import { transformedNormals, transformedPoints } from '../../scene/transformPoints.ts';
import type { Mesh, SampledMotion, SampledPointsMotion, StaticMotion, UniformMotion } from '../../scene/types.ts';
import { report, type StageContext } from './context.ts';
import { type Frame, scaledFrame } from './frame.ts';
import { affordableTimes, boxCorners, bytesOfPoints, carried, evenly, vectorsOf } from './sampling.ts';
import { unionOfTimes } from './xformOps.ts';

/** A mesh in its prim's own axes and stage units, and how its points change with time in there. */
export interface Shape {
  /** At the stage's start. */
  readonly mesh: Mesh;
  readonly deformation?: Deformation;
  /** Where it is, if not where its prim is: a skeleton carries it. */
  readonly frame?: Frame;
}
export interface Deformation {
  readonly times: Float64Array;
  at(time: number): DeformedPoints;
  /** As the file gives them [units per second], 3 per vertex; absent where it does not, or not at all times. */
  velocitiesAt?(time: number): Float32Array;
  /** Where its points do not move along chords between the times: some of them, 3 numbers each, that stand for all. */
  /** Where all of it is stored, if it was left in its file. */
  readonly stored?: StoredDeformation;
  readonly follow?: { readonly cost: number; pointsAt(time: number): ArrayLike<number> };
}
export interface StoredDeformation {
  readonly pointOfVertex: Uint32Array;
  readonly points: (time: number) => StoredSample;
  readonly normals: ((time: number) => StoredSample) | undefined;
}
export interface DeformedPoints {
  /** 3 per vertex of the mesh. */
  readonly positions: Float32Array;
  /** Absent where normals have to be computed. */
  readonly normals?: Float32Array;
}

export interface Placed {
  readonly mesh: Mesh;
  readonly motion: StaticMotion | SampledMotion | SampledPointsMotion;
}

interface Drifting {
  readonly mesh: Mesh;
  readonly motion: Placed['motion'] | UniformMotion;
}

interface Still extends Placed {
  readonly motion: StaticMotion;
}

/** Stretches that differ by less than this part are one: what an exporter's f32 rounding leaves. */
const RIGID = 1e-5;
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

/**
 * The motion of a mesh. What does not change with time is static, its scale and shear in the mesh. What moves without
 * changing shape gets sampled poses; all else sampled points.
 */
export function placeShape(context: StageContext, path: string, shape: Shape, frame: Frame): Placed {
  const world = scaledFrame(frame, context.unit);
  if (shape.deformation) return deforming(context, path, shape, world);
  if (world.times.length === 0) return fixed(shape.mesh, world.matrixAt(context.startCode));
  if (world.isStraight) return straight(context, path, shape.mesh, world);
  const times = refined(context, path, world, cornersOf(shape.mesh));
  const rigid = rigidPoses(times, world);
  if (!rigid) return sampledPoints(context, path, shape, world, times);
  return { mesh: stretched(shape.mesh, rigid.stretch), motion: sampledPoses(context, times, rigid.poses) };
}

/** The poses at some times and the stretch that is the same at all of them; undefined where it is not. */
function rigidPoses(times: Float64Array, { matrixAt }: Frame) {
  const { stretch } = mat4.decomposeRigid(matrixAt(times[0]));
  const unstretch = invert(stretch);
  const size = Math.max(...stretch.map(Math.abs));
  const poses: mat4.RigidPose[] = [];
  for (const time of times) {
    const m = matrixAt(time);
    const known = unstretch && mat4.poseOfStretched(m, unstretch);
    const own = known ? { pose: known, stretch } : mat4.decomposeRigid(m);
    if (!own.stretch.every((x, i) => Math.abs(x - stretch[i]) <= RIGID * size)) return undefined;
    poses.push(own.pose);
  }
  return { poses, stretch };
}

function straight(context: StageContext, path: string, mesh: Mesh, frame: Frame): Placed {
  const { matrixAt } = frame;
  const times = frame.isCounted ? frame.times : affordedSamples(context, path, frame.times, frame.cost);
  const { pose, stretch } = mat4.decomposeRigid(matrixAt(times[0]));
  const poses = Array.from(times, (time): mat4.RigidPose => {
    const m = matrixAt(time);
    return { ...pose, position: [m[3], m[7], m[11]] };
  });
  return { mesh: stretched(mesh, stretch), motion: sampledPoses(context, times, poses) };
}

/** The same without motion, at one time. */
export function placeStill(context: StageContext, shape: Shape, frame: Frame, time: number): Still {
  const bent = shape.deformation?.at(time);
  const mesh = bent ? bentMesh(shape.mesh, bent) : shape.mesh;
  return fixed(mesh, scaledFrame(frame, context.unit).matrixAt(time));
}

/** A shape in a frame that besides is carried along for ever by a velocity of the stage [units/s]; `frame`: where it is at time 0. */
export function placeDrifting(
  context: StageContext,
  path: string,
  shape: Shape,
  frame: Frame,
  velocity: Vec3,
): Drifting {
  if (frame.times.length === 0 && !shape.deformation) {
    const { mesh, motion } = placeStill(context, shape, frame, 0);
    return { mesh, motion: { kind: 'uniform', pose: motion.pose, velocity: scale(velocity, context.unit) } };
  }
  const carried = (time: number): mat4.Mat4 => {
    const [x, y, z] = scale(velocity, time / context.codesPerSecond);
    return mat4.multiply(mat4.fromParts([1, 0, 0, 0, 1, 0, 0, 0, 1], [x, y, z]), frame.matrixAt(time));
  };
  const times = unionOfTimes([frame.times, shape.deformation?.times ?? new Float64Array(0)]);
  return placeShape(context, path, shape, { times, cost: frame.cost + 1, matrixAt: (time) => carried(time ?? 0) });
}

function fixed(mesh: Mesh, matrix: mat4.Mat4): Still {
  const { pose, stretch } = mat4.decomposeRigid(matrix);
  return { mesh: stretched(mesh, stretch), motion: { kind: 'static', pose } };
}

/** The stretched forms of each mesh: instances of one size share theirs. */
const STRETCHED = new WeakMap<Mesh, Map<string, Mesh>>();
/** Parts of the greatest in which stretches are told apart: products of f64 matrices differ by less. */
const ALIKE = 1e-9;

function stretched(mesh: Mesh, stretch: readonly number[]): Mesh {
  const identity = stretch.every((x, i) => Math.abs(x - (i % 4 === 0 ? 1 : 0)) < 1e-12);
  if (identity) return mesh;
  const size = Math.max(...stretch.map(Math.abs));
  const key = [size.toPrecision(9), ...stretch.map((x) => Math.round(x / (ALIKE * size)))].join(' ');
  const known = STRETCHED.get(mesh) ?? new Map<string, Mesh>();
  STRETCHED.set(mesh, known);
  const made = known.get(key) ?? transformMesh(mesh, mat4.fromParts(stretch, [0, 0, 0]));
  known.set(key, made);
  return made;
}

/** Of each shape in its prim's axes. */
const CORNERS = new WeakMap<DeformedPoints, Float64Array>();

/** 3 numbers for each corner of the box around it. */
function cornersOf(mesh: DeformedPoints): Float64Array {
  const corners = CORNERS.get(mesh) ?? Float64Array.from(boxCorners(mesh.positions).flat());
  CORNERS.set(mesh, corners);
  return corners;
}

function refined(context: StageContext, path: string, world: Frame, corners: Float64Array): Float64Array {
  const size = farthest(carried(corners, mat4.fromParts(mat4.linearPart(world.matrixAt(world.times[0])), [0, 0, 0])));
  return followed(context, path, world, corners, context.chordTolerance * size);
}

/** Distance of the farthest of some points, 3 numbers each, from the origin. */
function farthest(points: readonly number[]): number {
  let most = 0;
  for (let i = 0; i < points.length; i += 3) most = Math.max(most, Math.hypot(points[i], points[i + 1], points[i + 2]));
  return most;
}

/** Times at which `corners` are followed along the frame's path, as closely as the scene's budget allows. */
function followed(
  context: StageContext,
  path: string,
  { times, cost, matrixAt }: Frame,
  corners: ArrayLike<number>,
  tolerance: number,
): Float64Array {
  const shape = (time: number): number[] => carried(corners, matrixAt(time));
  return followedShape(context, path, { times: affordedSamples(context, path, times, cost), cost, shape }, tolerance);
}

/** The samples that the scene still has time for. */
function affordedSamples(context: StageContext, path: string, written: Float64Array, cost: number): Float64Array {
  const samples = evenly(written, context.sampleBudget.take(written.length, cost));
  if (samples.length < written.length) {
    const message = `it is moved by ${written.length} samples, and all things of the scene together by more than there is room for; ${samples.length} of its samples are used (write out fewer, or move fewer things apart)`;
    report(context, 'warning', 'usd.sample-budget', path, message);
  }
  return samples;
}

interface ShapePath {
  readonly times: Float64Array;
  readonly cost: number;
  /** 3 numbers for each point that is followed. */
  shape(time: number): ArrayLike<number>;
}

function followedShape(
  context: StageContext,
  path: string,
  { times: samples, cost, shape }: ShapePath,
  tolerance: number,
): Float64Array {
  const looks = context.sampleBudget.looksClosely(samples.length) ? LOOKS : MIDDLE;
  const how = { tolerance, looks, halvings: MAX_HALVINGS };
  const { times, error, wanted } = context.motionBudget.refine(samples, shape, how, cost);
  if (error > tolerance) {
    const message = `it jumps or turns too fast between its ${samples.length} samples to be followed: about ${wanted.toPrecision(2)} samples would be needed, ${times.length} are used, and paths are off by up to ${error.toPrecision(2)} m; write more samples, or let it turn less between them`;
    report(context, 'warning', 'usd.resampling', path, message);
  }
  return times;
}

/** Poses as one motion, static where they are all the same. The signs of neighbouring quaternions agree. */
export function sampledPoses(
  context: Pick<StageContext, 'codesPerSecond'>,
  times: Float64Array,
  poses: readonly mat4.RigidPose[],
): StaticMotion | SampledMotion {
  const out = new Float64Array(times.length * 7);
  poses.forEach(({ position, orientation }, i) => {
    out.set(position, 7 * i);
    let cosine = 0;
    for (let k = 0; k < 4; k++) cosine += orientation[k] * (i > 0 ? out[7 * i - 4 + k] : orientation[k]);
    out.set(cosine < 0 ? orientation.map((x) => -x) : orientation, 7 * i + 3);
  });
  const moves = out.some((x, i) => x !== out[i % 7]);
  if (!moves || times.length < 2) return { kind: 'static', pose: poses[0] };
  return { kind: 'sampled', times: times.map((t) => t / context.codesPerSecond), poses: out };
}

/** How a prim's own axes move: of a camera or a light, which have no size. Their scale does not matter. */
export function frameMotion(context: StageContext, path: string, frame: Frame): StaticMotion | SampledMotion {
  const world = scaledFrame(frame, context.unit);
  const poseAt = (time: number): mat4.RigidPose => mat4.decomposeRigid(world.matrixAt(time)).pose;
  if (world.times.length === 0) return { kind: 'static', pose: poseAt(context.startCode) };
  const matrixAt = (time: number): mat4.Mat4 => mat4.fromPose(poseAt(time));
  const rigid = { times: world.times, cost: world.cost + POLAR_COST, matrixAt };
  const times = followed(context, path, rigid, AXES, FRAME_TOLERANCE);
  return sampledPoses(context, times, Array.from(times, poseAt));
}

function deforming(context: StageContext, path: string, shape: Shape, world: Frame): Placed {
  const { times, follow } = shape.deformation!;
  if (follow) return sampledPoints(context, path, shape, world, bentTimes(context, path, shape, world));
  if (world.times.length === 0) return sampledPoints(context, path, shape, world, times);
  const corners = cornersOf(shape.mesh);
  const both = { ...world, times: unionOfTimes([times, world.times]) };
  const moving = context.cubic ? withCubicPoints(shape) : shape;
  return sampledPoints(context, path, moving, world, refined(context, path, both, corners));
}

/** The same with points that go along cubics between their samples. */
function withCubicPoints(shape: Shape): Shape {
  const { deformation } = shape;
  if (!deformation) return shape;
  const { times } = deformation;
  const at = (time: number): DeformedPoints => {
    const { before, after, s } = pieceAt(times, time);
    if (before === after || s === 0) return deformation.at(times[before]);
    const sample = (k: number): Float32Array => deformation.at(times[k]).positions;
    const [from, to] = [before, after].map((k) => parabolaVelocityAt(times, sample, k));
    const [a, b] = [sample(before), sample(after)];
    const positions = a.map((x, i) => hermite(x, from[i], b[i], to[i], times[after] - times[before], s));
    return { ...deformation.at(time), positions };
  };
  return { ...shape, deformation: { ...deformation, at } };
}

/** Times at which what bends on curved ways is followed; with a wider tolerance where its points would not be held. */
function bentTimes(context: StageContext, path: string, { deformation, mesh }: Shape, world: Frame): Float64Array {
  const { times, follow } = deformation!;
  const samples = affordedSamples(context, path, unionOfTimes([times, world.times]), world.cost);
  const shape = (time: number): number[] => carried(follow!.pointsAt(time), world.matrixAt(time));
  const size = diagonal(shape(samples[0]));
  const most = Math.floor(context.pointBudget.bytes / bytesOfPoints(1, mesh.positions.length / 3, vectorsOf(context)));
  const way: ShapePath = { times: samples, cost: world.cost + follow!.cost, shape };
  for (let tolerance = context.bendTolerance * size; ; tolerance *= 4) {
    const found = followedShape(context, path, way, tolerance);
    const isEnough = found.length <= Math.max(most, samples.length) || !(tolerance < size) || tolerance === 0;
    if (isEnough) return found;
  }
}

function diagonal(points: ArrayLike<number>): number {
  const corners = boxCorners(points);
  return distance(corners[0], corners[corners.length - 1]);
}

/** The times that the scene still has memory for. */
function affordable(context: StageContext, path: string, wanted: Float64Array, vertices: number): Float64Array {
  const { pointBudget } = context;
  const perTime = bytesOfPoints(1, vertices, vectorsOf(context));
  const times = affordableTimes(wanted, perTime, pointBudget.bytes);
  pointBudget.bytes = Math.max(0, pointBudget.bytes - times.length * perTime);
  if (times.length < wanted.length) {
    const message = `its ${vertices} vertices at ${wanted.length} times take more memory than there is for a scene's points; ${times.length} of the times are used`;
    report(context, 'warning', 'usd.sample-budget', path, message);
  }
  return times;
}

/** Whether samples are too many for memory. Those that are not take of it. */
function leftInFile(context: StageContext, times: number, vertices: number): boolean {
  const { sampleMemory } = context;
  const left = sampleMemory.bytes - bytesOfPoints(times, vertices, vectorsOf(context));
  if (left >= 0) sampleMemory.bytes = left;
  return left < 0;
}

/** Every vertex at every time, to be read when it is needed; as `sampledPoints` makes it. */
function streamedPoints(
  context: StageContext,
  path: string,
  mesh: Mesh,
  { pointOfVertex, points, normals }: StoredDeformation,
  world: Frame,
  codes: Float64Array,
): Placed {
  const origin = originOf((k) => gatherPoints(readSample(points(codes[k])), pointOfVertex), codes, world);
  const recipe: PointRecipe = {
    samples: Array.from(codes, (time) => ({
      points: points(time),
      matrix: relativeTo(origin, world.matrixAt(time)),
    })),
    pointOfVertex,
    shading: normals
      ? { kind: 'stored', normals: Array.from(codes, normals) }
      : { kind: 'faces', indices: mesh.indices, groups: smoothingGroups(mesh) },
  };
  const times = codes.map((t) => t / context.codesPerSecond);
  if (context.cubic) {
    const message = 'its samples are too many for memory and stay in their file; between them its points go straight';
    report(context, 'info', 'usd.between-samples', path, message);
  }
  const facts = surveyPoints(recipe, context.progress);
  const first = { positions: makePoints(recipe, 0), normals: makeNormals(recipe, 0) };
  return {
    mesh: { ...mesh, ...first, indices: facing(mesh.indices, world.matrixAt(codes[0])) },
    motion: { kind: 'sampled-points', times, origin, points: { ...recipe, facts } },
  };
}

/** Every vertex at every time. */
function sampledPoints(context: StageContext, path: string, shape: Shape, world: Frame, wanted: Float64Array): Placed {
  const { mesh, deformation } = shape;
  const stored = deformation?.stored;
  if (stored && leftInFile(context, wanted.length, mesh.positions.length / 3))
    return streamedPoints(context, path, mesh, stored, world, wanted);
  const times = affordable(context, path, wanted, mesh.positions.length / 3);
  const shapes = Array.from(times, (time): DeformedPoints => deformation?.at(time) ?? mesh);
  const groups = shapes.some(({ normals }) => !normals) ? smoothingGroups(mesh) : undefined;
  const origin = originOf((k) => shapes[k].positions, times, world);
  const placed = shapes.map(({ positions, normals }, i) => {
    const own = normals ?? deformedNormals(positions, mesh.indices, groups!);
    const matrix = relativeTo(origin, world.matrixAt(times[i]));
    return { positions: transformedPoints(positions, matrix), normals: transformedNormals(own, matrix) };
  });
  const seconds = times.map((t) => t / context.codesPerSecond);
  const points = placed.map((p) => p.positions);
  if (deformation && !deformation.follow) noteGap(context, path, seconds, points);
  const given = context.cubic && world.times.length === 0 ? deformation?.velocitiesAt : undefined;
  const turn = mat4.fromParts(mat4.linearPart(world.matrixAt(times[0])), [0, 0, 0]);
  const motion: SampledPointsMotion = {
    kind: 'sampled-points',
    times: seconds,
    origin,
    points,
    ...(context.cubic && {
      velocities: given
        ? Array.from(times, (time) => transformedPoints(given(time), turn))
        : parabolaVelocities(seconds, points),
    }),
    normals: placed.map((p) => p.normals),
  };
  return { mesh: { ...mesh, ...placed[0], indices: facing(mesh.indices, world.matrixAt(times[0])) }, motion };
}

/** Says how much its samples leave open of how a mesh deforms: by how far cubics through them are from chords. */
function noteGap(context: StageContext, path: string, times: Float64Array, points: readonly Float32Array[]): void {
  const gap = chordGap(times, points);
  const corners = boxCorners(points[0]);
  if (gap <= context.chordTolerance * distance(corners[0], corners[corners.length - 1])) return;
  const [shown, other] = context.cubic ? ['cubics', 'straight'] : ['straight', 'along cubics'];
  const message = `between its ${times.length} samples its points go ${context.cubic ? 'along ' : ''}${shown}; ${other} they would be up to ${gap.toPrecision(2)} m elsewhere`;
  report(context, 'info', 'usd.between-samples', path, message);
}

/** Triangles that show the same side where M mirrors. */
const facing = (indices: Uint32Array, m: mat4.Mat4): Uint32Array =>
  determinant(mat4.linearPart(m)) < 0 ? turned(indices) : indices;

const relativeTo = (origin: Vec3, m: mat4.Mat4): mat4.Mat4 =>
  m.map((x, i) => (i % 4 === 3 && i < 12 ? x - origin[(i - 3) / 4] : x));

function turned(indices: Uint32Array): Uint32Array {
  const out = indices.slice();
  for (let i = 0; i < out.length; i += 3) [out[i + 1], out[i + 2]] = [indices[i + 2], indices[i + 1]];
  return out;
}

/** The mesh as it is bent at some time. */
export function bentMesh(mesh: Mesh, { positions, normals }: DeformedPoints): Mesh {
  return { ...mesh, positions, normals: normals ?? deformedNormals(positions, mesh.indices, smoothingGroups(mesh)) };
}

/** An origin is chosen by so many samples at most. */
const ORIGIN_SAMPLES = 32;

/** The prim's own origin where it is near (so that its points stay as written), else the middle of the points. */
function originOf(positionsOf: (k: number) => Float32Array, times: Float64Array, world: Frame): Vec3 {
  const step = Math.ceil(times.length / ORIGIN_SAMPLES);
  const corners = Array.from(times.keys()).flatMap((k) => {
    if (k % step !== 0) return [];
    const m = world.matrixAt(times[k]);
    return carried(boxCorners(positionsOf(k)).flat(), m);
  });
  const box = boxCorners(corners);
  const [low, high] = [box[0], box[box.length - 1]];
  const middle: Vec3 = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
  const own = mat4.transformPoint(world.matrixAt(times[0]), [0, 0, 0]);
  return distance(own, middle) <= distance(low, high) ? own : middle;
}
