import type { Vec3 } from '../../math/vec3.ts';
import { pointAt } from '../mesh/polygons.ts';
import type { SampledPointsMotion } from '../types.ts';
import type { StreamedPoints } from './storedPoints.ts';
import { makePoint, streamedNormals, streamedPoints } from './streamedPoints.ts';

type PointSamples = Pick<SampledPointsMotion, 'points' | 'normals'>;

/** Whether the samples of a deforming mesh are read from files on demand. */
export const isStreamed = (points: SampledPointsMotion['points']): points is StreamedPoints => 'statistics' in points;

/** Number of samples. */
export const sampleCount = ({ points }: SampledPointsMotion): number =>
  isStreamed(points) ? points.samples.length : points.length;

/**
 * Sample k: 3 numbers per vertex, world-oriented, relative to the motion's origin [m]; do not write to it. Streamed samples are read from their file
 * synchronously, which is impossible on the page's main thread.
 */
export const pointsAt = ({ points }: PointSamples, k: number): Float32Array =>
  isStreamed(points) ? streamedPoints(points, k) : points[k];

/** World-frame normals at sample k; undefined if they are the mesh's. */
export const normalsAt = ({ points, normals }: PointSamples, k: number): Float32Array | undefined =>
  isStreamed(points) ? streamedNormals(points, k) : normals?.[k];

/** One vertex at sample k [m], relative to the motion's origin. */
export const vertexAt = ({ points }: SampledPointsMotion, k: number, vertex: number): Vec3 =>
  isStreamed(points) ? pointAt(makePoint(points, k, vertex), 0) : pointAt(points[k], vertex);
