import type { Vec3 } from '../../math/vec3.ts';
import { pointAt } from '../mesh/polygons.ts';
import type { SampledPointsMotion } from '../types.ts';
import { type BlendedPoints, blendedVertex, makeBlendedNormals, makeBlendedPoints } from './blendedPoints.ts';
import { cachedSample } from './sampleCache.ts';
import type { StreamedPoints } from './storedPoints.ts';
import { makeNormals, makePoint, makePoints } from './streamedPoints.ts';

type Points = SampledPointsMotion['points'];
type PointSamples = Pick<SampledPointsMotion, 'points' | 'normals'>;

/** Whether the samples of a deforming mesh are read from files on demand. */
export const isStreamed = (points: Points): points is StreamedPoints => 'statistics' in points;

/** Whether the samples of a deforming mesh are evaluated from its joints. */
export const isBlended = (points: Points): points is BlendedPoints => 'poses' in points;

/** Whether the samples of a deforming mesh are all in memory. */
export const isListed = (points: Points): points is readonly Float32Array[] => Array.isArray(points);

/** Number of samples. */
export function sampleCount({ points }: Pick<SampledPointsMotion, 'points'>): number {
  if (isStreamed(points)) return points.samples.length;
  return isBlended(points) ? points.nodes.length : points.length;
}

/**
 * Sample k: 3 numbers per vertex, world-oriented, relative to the motion's origin [m]; do not write to it. Samples that are not in memory are cached. Streamed
 * ones are read from their file synchronously, which is impossible on the page's main thread.
 */
export function pointsAt({ points }: Pick<PointSamples, 'points'>, k: number): Float32Array {
  if (isStreamed(points)) return cachedSample(points, k, makePoints);
  return isBlended(points) ? cachedSample(points, k, makeBlendedPoints) : points[k];
}

/** World-frame normals at sample k; undefined if they are the mesh's. */
export function normalsAt({ points, normals }: PointSamples, k: number): Float32Array | undefined {
  if (isStreamed(points)) return cachedSample(points, k, makeNormals);
  return isBlended(points) ? cachedSample(points, k, makeBlendedNormals) : normals?.[k];
}

/** One vertex at each sample [m], relative to the motion's origin. */
export function vertexSamples({ points }: Pick<PointSamples, 'points'>, vertex: number): (k: number) => Vec3 {
  if (isStreamed(points)) return (k) => pointAt(makePoint(points, k, vertex), 0);
  if (isListed(points)) return (k) => pointAt(points[k], vertex);
  const at = blendedVertex(points, vertex);
  return (k) => pointAt(at(k), 0);
}

/** The motion with all samples in memory. */
export function withListedPoints(
  motion: SampledPointsMotion,
): SampledPointsMotion & { readonly points: readonly Float32Array[] } {
  const { points } = motion;
  if (isListed(points)) return { ...motion, points };
  const samples = Array.from(motion.times.keys());
  if (isStreamed(points))
    return {
      ...motion,
      points: samples.map((k) => makePoints(points, k)),
      normals: samples.map((k) => makeNormals(points, k)),
    };
  return {
    ...motion,
    points: samples.map((k) => makeBlendedPoints(points, k)),
    normals: samples.map((k) => makeBlendedNormals(points, k)),
  };
}
