import type { Mat4 } from '../../../math/mat4.ts';
import { IDENTITY } from '../../../math/quat.ts';
import { add, lerp, scale, type Vec3 } from '../../../math/vec3.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { type BoundingBox, boxSupport, sampleBoundingBox } from '../../bounds/bounds.ts';
import { transformPointsInPlace } from '../../mesh/transformPoints.ts';
import { transformBlendedPoints, translateBlendedPoints } from '../../streaming/blendedPoints.ts';
import { isBlended, isStreamed, sampleCount } from '../../streaming/samplePoints.ts';
import { transformStreamedPoints, translateStreamedPoints } from '../../streaming/streamedPoints.ts';
import type { Diagnostic, SampledPointsMotion } from '../../types.ts';
import { almostC, inUnitsOfC, problem, roundedUp, seconds, validateFastest } from '../../validation/motionFindings.ts';
import { isCubic, MAX_CONTROL_SPEED, maxControlSpeed, straightenedPieces } from '../cubicPoints.ts';
import { deformedPoints, deformedVertexLine } from '../deformedPoints.ts';
import { pieceAt } from '../poses.ts';
import { type FlightPath, linearOf, type SimilarityTransform, toWorldTime, transformPose } from './changes.ts';
import { fastestOfPoints } from './fastestPoints.ts';
import type { MotionKind, ObjectWith } from './motionKind.ts';
import { ofVertices } from './rigidMotion.ts';

function vertexPlacer({ motion }: ObjectWith<SampledPointsMotion>, t: number, c: number) {
  const at = deformedPoints(motion, t, c);
  return (i: number): Vec3 => add(motion.origin, at(i));
}

function interpolatedBox(motion: SampledPointsMotion, t: number): BoundingBox | undefined {
  const { before, after, s } = pieceAt(motion.times, t);
  const [a, b] = [sampleBoundingBox(motion, before), sampleBoundingBox(motion, after)];
  const between = (p: Vec3, q: Vec3): Vec3 => add(motion.origin, lerp(p, q, s));
  return a && b && { min: between(a.min, b.min), max: between(a.max, b.max) };
}

const vertices = ofVertices(vertexPlacer);

function nonFiniteText({ times, points, velocities }: SampledPointsMotion): Message | undefined {
  const broken = (all: readonly Float32Array[]) => all.findIndex((numbers) => numbers.some((x) => !Number.isFinite(x)));
  if (isBlended(points)) return undefined;
  const k = Math.max(isStreamed(points) ? points.statistics.firstNonFinite : broken(points), broken(velocities ?? []));
  return k < 0 ? undefined : msg`the points or velocities at ${seconds(times[k])} have a number that is not finite`;
}

function validateSpeed({ motion, path }: ObjectWith<SampledPointsMotion>, c: number): Diagnostic[] {
  const found = validateFastest(path, fastestOfPoints(motion, c, almostC(c)), c);
  return found.length > 0 ? found : validateBends(motion, path, c);
}

/** Pieces of a cubic motion that are shown straighter than they are because they would exceed c. */
function validateBends(motion: SampledPointsMotion, path: string, c: number): Diagnostic[] {
  if (!isCubic(motion)) return [];
  const pieces = straightenedPieces(motion, c);
  const [first] = pieces;
  if (!first) return [];
  const speed = Math.max(...pieces.map(({ k }) => maxControlSpeed(motion, k)));
  const lost = Math.max(...pieces.map((piece) => piece.lost));
  const from = seconds(motion.times[first.k]);
  const message = msg`between samples its cubic path could reach ${inUnitsOfC(speed / c)} c, first at t = ${from}; ${pieces.length} of ${motion.times.length - 1} pieces are shown straighter, by up to ${Math.ceil(100 * lost)} %, and velocities jump there; raise c above ${roundedUp(speed / MAX_CONTROL_SPEED)} m/s or write more samples`;
  return [problem('warning', 'motion.cubic', path, message)];
}

function transform(motion: SampledPointsMotion, by: SimilarityTransform): SampledPointsMotion {
  const linear = linearOf(by.orientation, by.scale);
  const turn = linearOf(by.orientation, 1);
  const origin = transformPose({ position: motion.origin, orientation: by.orientation }, by).position;
  const { points, velocities, normals } = motion;
  return {
    ...motion,
    origin,
    points: transformedPoints(points, linear),
    ...(velocities && { velocities: velocities.map((each) => carried(each, linear)) }),
    ...(normals && { normals: normals.map((each) => carried(each, turn)) }),
  };
}

function transformedPoints(points: SampledPointsMotion['points'], linear: Mat4): SampledPointsMotion['points'] {
  if (isStreamed(points)) return transformStreamedPoints(points, linear);
  return isBlended(points) ? transformBlendedPoints(points, linear) : points.map((each) => carried(each, linear));
}

const carried = (vectors: Float32Array, linear: Mat4): Float32Array => transformPointsInPlace(vectors.slice(), linear);

/** How long a deforming object keeps flying before its first and after its last sample, in lengths of the scene's time range. */
const LEAD = 20;
/** [s] */
const MIN_LEAD = 60;
/** Duration of a velocity jump as a fraction of the motion's time. */
const JUMP = 1e-6;

function fly(motion: SampledPointsMotion, { velocity, at, range }: FlightPath): SampledPointsMotion {
  const { times, points, velocities, normals } = motion;
  const last = times.length - 1;
  const lead = Math.max(MIN_LEAD, LEAD * range);
  // A cubic has one velocity per sample, so a jump of velocity at its begin and end takes a short additional piece.
  const jump = velocities ? [JUMP * (times[last] - times[0])] : [];
  const before = [lead, ...jump].map((ahead) => times[0] - ahead);
  const after = [...jump, lead].map((behind) => times[last] + behind);
  const samples = [...before.map(() => 0), ...times.keys(), ...after.map(() => last)];
  const longer = Float64Array.of(...before, ...times, ...after);
  const moves = (i: number): boolean => i >= before.length && i < before.length + times.length;
  const shifts = Float64Array.from(samples.flatMap((_, i) => scale(velocity, longer[i] - at)));
  if (isStreamed(points)) return { ...motion, times: longer, points: translateStreamedPoints(points, samples, shifts) };
  if (isBlended(points)) return { ...motion, times: longer, points: translateBlendedPoints(points, samples, shifts) };
  const shifted = samples.map((k, i) => points[k].map((x, j) => x + shifts[3 * i + (j % 3)]));
  return {
    ...motion,
    times: longer,
    points: shifted,
    ...(velocities && {
      velocities: samples.map((k, i) => velocities[k].map((v, j) => (moves(i) ? v : 0) + velocity[j % 3])),
    }),
    ...(normals && { normals: samples.map((k) => normals[k]) }),
  };
}

export const SAMPLED_POINTS_MOTION: MotionKind<SampledPointsMotion> = {
  isStatic: false,
  deforms: true,
  approachesC: false,
  restingPose: () => undefined,
  fixedOrientation: () => undefined,
  sampleTimes: ({ times }) => times,
  sampleCount,
  poseSamples: () => undefined,
  pointSamples: (motion) => motion,
  numbers: ({ times, origin }) => [times, origin],
  // Its frame is at the origin, without rotation.
  poseAt: ({ origin }) => ({ position: origin, orientation: IDENTITY }),
  vertexWorldLine: ({ motion }, i, c) => deformedVertexLine(motion, i, c),
  vertexPlacer,
  bounds: (object, t, c) =>
    isStreamed(object.motion.points) ? interpolatedBox(object.motion, t) : vertices.bounds(object, t, c),
  support: (object, t, c) =>
    isStreamed(object.motion.points) ? boxSupport(interpolatedBox(object.motion, t)) : vertices.support(object, t, c),
  fastestVertex: ({ motion }, c, _range, atLeast) => fastestOfPoints(motion, c, atLeast),
  keepsFastest: ({ velocities }) => velocities === undefined,
  restToWorld: (object) => object,
  nonFiniteText,
  validateSpeed,
  retime: (motion, map) => {
    const velocities = motion.velocities?.map((each) => each.map((v) => v / map.a));
    return { ...motion, times: motion.times.map((t) => toWorldTime(t, map)), ...(velocities && { velocities }) };
  },
  transform,
  fly,
};
