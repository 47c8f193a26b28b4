import { hermite } from '../../../../math/hermite.ts';
import { determinant } from '../../../../math/mat3.ts';
import * as mat4 from '../../../../math/mat4.ts';
import { distance, type Vec3 } from '../../../../math/vec3.ts';
import { msg } from '../../../../messages/message.ts';
import { gatherPoints } from '../../../../scene/mesh/makeMesh.ts';
import { flippedWinding } from '../../../../scene/mesh/meshOps.ts';
import { deformedNormals, smoothingGroups } from '../../../../scene/mesh/normals.ts';
import { withoutQuadric } from '../../../../scene/mesh/quadric.ts';
import { transformNormalsInPlace, transformPointsInPlace } from '../../../../scene/mesh/transformPoints.ts';
import { AdaptivePath } from '../../../../scene/motion/adaptiveSampling.ts';
import { estimateChordError, parabolaVelocities, parabolaVelocityAt } from '../../../../scene/motion/cubicPoints.ts';
import { pieceAt } from '../../../../scene/motion/poses.ts';
import { computePointStatistics } from '../../../../scene/streaming/pointStatistics.ts';
import { readSample } from '../../../../scene/streaming/storedNumbers.ts';
import type { PointRecipe } from '../../../../scene/streaming/storedPoints.ts';
import { makeNormals, makePoints } from '../../../../scene/streaming/streamedPoints.ts';
import type { Mesh, SampledPointsMotion } from '../../../../scene/types.ts';
import { report } from '../../diagnostics.ts';
import type { StageContext } from '../context.ts';
import {
  affordableTimes,
  boxCorners,
  pointBytes,
  transformedPoints,
  vectorsPerVertex,
} from '../geometry/pointSampling.ts';
import type { DeformedPoints, PlacedMesh, PrimGeometry, StoredDeformation } from '../geometry/primGeometry.ts';
import { Memo } from '../transforms/memo.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import {
  boundingBoxCorners,
  budgetedSamples,
  maxOverSamples,
  resampledPath,
  resampledTimes,
  toleranceOf,
} from './resampling.ts';

export function placeDeforming(
  context: StageContext,
  path: string,
  shape: PrimGeometry,
  world: StageTransform,
): PlacedMesh {
  const { times, probe } = shape.deformation!;
  if (probe) return sampledPoints(context, path, shape, world, resampledSkinTimes(context, path, shape, world));
  if (world.times.length === 0) return sampledPoints(context, path, shape, world, times);
  const corners = boundingBoxCorners(shape.mesh);
  const both = { ...world, times: unionOfTimes([times, world.times]) };
  const moving = context.cubic ? withCubicPoints(shape) : shape;
  return sampledPoints(context, path, moving, world, resampledTimes(context, path, both, corners));
}

/** The same geometry with cubic interpolation of its points. */
function withCubicPoints(shape: PrimGeometry): PrimGeometry {
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

/** Times at which a skinned mesh is sampled; the tolerance is widened until its points fit into memory. */
function resampledSkinTimes(
  context: StageContext,
  path: string,
  { deformation, mesh }: PrimGeometry,
  world: StageTransform,
): Float64Array {
  const { times, probe } = deformation!;
  const samples = budgetedSamples(context, path, unionOfTimes([times, world.times]), world.cost);
  const shape = (time: number): Float64Array => transformedPoints(probe!.pointsAt(time), world.matrixAt(time));
  const size = maxOverSamples(samples, (time) => diagonal(shape(time)));
  const most = Math.floor(
    context.pointBudget.bytes / pointBytes(1, mesh.positions.length / 3, vectorsPerVertex(context)),
  );
  for (let tolerance = context.bendTolerance * size; ; tolerance *= 4) {
    const refined = new AdaptivePath(samples, shape, toleranceOf(context, samples, tolerance));
    const found = resampledPath(context, path, refined, world.cost + probe!.cost, tolerance);
    const isEnough = found.length <= Math.max(most, samples.length) || !(tolerance < size) || tolerance === 0;
    if (isEnough) return found;
  }
}

function diagonal(points: ArrayLike<number>): number {
  const corners = boxCorners(points);
  return distance(corners[0], corners[corners.length - 1]);
}

/** The times that fit into the scene's remaining memory. */
function budgetedTimes(context: StageContext, path: string, requested: Float64Array, vertices: number): Float64Array {
  const { pointBudget } = context;
  const perTime = pointBytes(1, vertices, vectorsPerVertex(context));
  const times = affordableTimes(requested, perTime, pointBudget.bytes);
  pointBudget.bytes = Math.max(0, pointBudget.bytes - times.length * perTime);
  if (times.length < requested.length) {
    const message = msg`its ${vertices} vertices at ${requested.length} times take more memory than there is for a scene's points; ${times.length} of the times are used`;
    report(context, 'warning', 'usd.sample-budget', path, message);
  }
  return times;
}

/** Whether samples exceed the remaining memory; if not, they are subtracted from it. */
function staysInFile(context: StageContext, times: number, vertices: number): boolean {
  const { sampleMemory } = context;
  const left = sampleMemory.bytes - pointBytes(times, vertices, vectorsPerVertex(context));
  if (left >= 0) sampleMemory.bytes = left;
  return left < 0;
}

/** As `sampledPoints`, but the points are read from the file when they are needed. */
function streamedPoints(
  context: StageContext,
  path: string,
  mesh: Mesh,
  { pointOfVertex, points, normals }: StoredDeformation,
  world: StageTransform,
  codes: Float64Array,
): PlacedMesh {
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
    const message = msg`its samples are too many for memory and stay in their file; between them its points go straight`;
    report(context, 'info', 'usd.between-samples', path, message);
  }
  const statistics = computePointStatistics(recipe, context.progress);
  const first = { positions: makePoints(recipe, 0), normals: makeNormals(recipe, 0) };
  return {
    mesh: { ...mesh, ...first, indices: facingIndices(mesh.indices, world.matrixAt(codes[0])) },
    motion: { kind: 'sampled-points', times, origin, points: { ...recipe, statistics } },
  };
}

const SAMPLED_POINTS = new Memo<SampledPlacement>();

/** A mesh with every vertex sampled at every time, in metres. */
export function sampledPoints(
  context: StageContext,
  path: string,
  shape: PrimGeometry,
  world: StageTransform,
  requested: Float64Array,
): PlacedMesh {
  const { mesh, deformation } = shape;
  const stored = deformation?.stored;
  if (stored && staysInFile(context, requested.length, mesh.positions.length / 3))
    return streamedPoints(context, path, mesh, stored, world, requested);
  const times = budgetedTimes(context, path, requested, mesh.positions.length / 3);
  const sampled = SAMPLED_POINTS.getOrCreate(shape, [world, times], () => sampledAt(context, shape, world, times));
  if (sampled.gap) reportGap(context, path, times.length, sampled.gap);
  return sampled.placed;
}

interface SampledPlacement {
  readonly placed: PlacedMesh;
  /** Absent for skinned meshes, which are resampled to a tolerance. */
  readonly gap?: ChordGap;
}

interface ChordGap {
  /** Maximum distance between cubics through the samples and their chords [m]. */
  readonly max: number;
  /** Distance up to which nothing is reported [m]. */
  readonly tolerance: number;
}

function sampledAt(
  context: StageContext,
  { mesh, deformation }: PrimGeometry,
  world: StageTransform,
  times: Float64Array,
): SampledPlacement {
  const shapes = Array.from(times, (time): DeformedPoints => deformation?.at(time) ?? copiedPoints(mesh));
  const groups = shapes.some(({ normals }) => !normals) ? smoothingGroups(mesh) : undefined;
  const origin = originOf((k) => shapes[k].positions, times, world);
  const placed = shapes.map(({ positions, normals }, i) => {
    const own = normals ?? deformedNormals(positions, mesh.indices, groups!);
    const matrix = relativeTo(origin, world.matrixAt(times[i]));
    return { positions: transformPointsInPlace(positions, matrix), normals: transformNormalsInPlace(own, matrix) };
  });
  const seconds = times.map((t) => t / context.codesPerSecond);
  const points = placed.map((p) => p.positions);
  const authored = context.cubic && world.times.length === 0 ? deformation?.velocitiesAt : undefined;
  const turn = mat4.fromParts(mat4.linearPart(world.matrixAt(times[0])), [0, 0, 0]);
  const motion: SampledPointsMotion = {
    kind: 'sampled-points',
    times: seconds,
    origin,
    points,
    ...(context.cubic && {
      velocities: authored
        ? Array.from(times, (time) => transformPointsInPlace(authored(time), turn))
        : parabolaVelocities(seconds, points),
    }),
    normals: placed.map((p) => p.normals),
  };
  const drawn = { ...mesh, ...placed[0], indices: facingIndices(mesh.indices, world.matrixAt(times[0])) };
  const hasGap = deformation && !deformation.probe;
  return { placed: { mesh: drawn, motion }, ...(hasGap && { gap: chordGapOf(context, seconds, points) }) };
}

function chordGapOf(context: StageContext, times: Float64Array, points: readonly Float32Array[]): ChordGap {
  const corners = boxCorners(points[0]);
  const tolerance = context.chordTolerance * distance(corners[0], corners[corners.length - 1]);
  return { max: estimateChordError(times, points), tolerance };
}

const copiedPoints = ({ positions, normals }: Mesh): DeformedPoints => ({
  positions: positions.slice(),
  normals: normals.slice(),
});

/** Reports how much a deformation depends on the interpolation between its samples. */
function reportGap(context: StageContext, path: string, times: number, { max: most, tolerance }: ChordGap): void {
  if (most <= tolerance) return;
  const gap = most.toPrecision(2);
  const message = context.cubic
    ? msg`between its ${times} samples its points go along cubics; straight they would be up to ${gap} m elsewhere`
    : msg`between its ${times} samples its points go straight; along cubics they would be up to ${gap} m elsewhere`;
  report(context, 'info', 'usd.between-samples', path, message, { off: most });
}

/** Triangles with flipped winding if M mirrors, so that they face the same side. */
export const facingIndices = (indices: Uint32Array, m: mat4.Mat4): Uint32Array =>
  determinant(mat4.linearPart(m)) < 0 ? flippedWinding(indices) : indices;

export const relativeTo = (origin: Vec3, m: mat4.Mat4): mat4.Mat4 =>
  m.map((x, i) => (i % 4 === 3 && i < 12 ? x - origin[(i - 3) / 4] : x));

/** The mesh with deformed points. */
export function deformedMesh(mesh: Mesh, { positions, normals }: DeformedPoints): Mesh {
  const shading = normals ?? deformedNormals(positions, mesh.indices, smoothingGroups(mesh));
  return { ...withoutQuadric(mesh), positions, normals: shading };
}

/** Maximum number of samples from which the origin is chosen. */
const ORIGIN_SAMPLES = 32;

/** The prim's own origin if it is near the points (so that they keep their authored values), else their centre. */
function originOf(positionsOf: (k: number) => Float32Array, times: Float64Array, world: StageTransform): Vec3 {
  const step = Math.ceil(times.length / ORIGIN_SAMPLES);
  const corners = Array.from(times.keys()).flatMap((k) => {
    if (k % step !== 0) return [];
    const m = world.matrixAt(times[k]);
    return [...transformedPoints(boxCorners(positionsOf(k)).flat(), m)];
  });
  const box = boxCorners(corners);
  const [low, high] = [box[0], box[box.length - 1]];
  const middle: Vec3 = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
  const own = mat4.transformPoint(world.matrixAt(times[0]), [0, 0, 0]);
  return distance(own, middle) <= distance(low, high) ? own : middle;
}
