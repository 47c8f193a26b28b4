import type { Vec3 } from '../../math/vec3.ts';
import { pointAt } from '../mesh/polygons.ts';
import type { SampledPointsMotion } from '../types.ts';
import type { StreamedPoints } from './storedPoints.ts';
import { makePoint, streamedNormals, streamedPoints } from './streamedPoints.ts';

type PointSamples = Pick<SampledPointsMotion, 'points' | 'normals'>;

/** Whether the samples of a deforming mesh are left in their file, and not in memory. */
export const isStreamed = (points: SampledPointsMotion['points']): points is StreamedPoints => 'statistics' in points;

/** How many samples there are. */
export const sampleCount = ({ points }: SampledPointsMotion): number =>
  isStreamed(points) ? points.samples.length : points.length;

/**
 * Sample k: 3 numbers per vertex, world-oriented, relative to the motion's origin [m]; not to be written to. What is left
 * in a file is read, which a thread of the page that draws cannot do.
 */
export const pointsAt = ({ points }: PointSamples, k: number): Float32Array =>
  isStreamed(points) ? streamedPoints(points, k) : points[k];

/** World-frame normals at sample k; undefined where they are the mesh's. */
export const normalsAt = ({ points, normals }: PointSamples, k: number): Float32Array | undefined =>
  isStreamed(points) ? streamedNormals(points, k) : normals?.[k];

/** One vertex at sample k [m], from the motion's origin. */
export const vertexAt = ({ points }: SampledPointsMotion, k: number, vertex: number): Vec3 =>
  isStreamed(points) ? pointAt(makePoint(points, k, vertex), 0) : pointAt(points[k], vertex);
