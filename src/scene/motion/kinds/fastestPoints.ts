import { withBend } from '../../../physics/worldLines/cubicPiece.ts';
import { displacementBounds } from '../../streaming/blendedBounds.ts';
import { type BlendedPoints, makeBlendedPoints } from '../../streaming/blendedPoints.ts';
import { longestDisplacement } from '../../streaming/pointStatistics.ts';
import { isBlended, isStreamed } from '../../streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../../types.ts';
import {
  bendFactor,
  type CubicPointsMotion,
  isCubic,
  maxControlSpeed,
  maxPieceSpeed,
  pointPiece,
  pointSpeedBound,
} from '../cubicPoints.ts';
import { type FastestVertex, REST } from './motionKind.ts';

/** The fastest vertex between samples. */
export const fastestOfPoints = (motion: SampledPointsMotion, c: number, atLeast: number): FastestVertex =>
  isCubic(motion) ? fastestCubic(motion, c, atLeast) : fastestPolyline(motion, atLeast);

function fastestPolyline({ times, points }: SampledPointsMotion, atLeast: number): FastestVertex {
  if (isBlended(points)) return fastestBlended(times, points, atLeast);
  let best: FastestVertex = { ...REST, speed: atLeast };
  for (let k = 0; k + 1 < times.length; k++) {
    const { length, vertex } = isStreamed(points)
      ? { length: points.statistics.displacements[k], vertex: points.statistics.fastest[k] }
      : longestDisplacement(points[k], points[k + 1]);
    const speed = length / (times[k + 1] - times[k]);
    if (speed > best.speed) best = { speed, vertex, from: times[k], to: times[k + 1] };
  }
  return best.from === REST.from ? REST : best;
}

/** Evaluates pieces in the order of their bounds, until no other can have a faster vertex. */
function fastestBlended(times: Float64Array, points: BlendedPoints, atLeast: number): FastestVertex {
  const bounds = displacementBounds(points).map((most, k) => most / (times[k + 1] - times[k]));
  let best: FastestVertex = { ...REST, speed: atLeast };
  const candidates = Array.from(bounds.keys()).filter((k) => bounds[k] > atLeast);
  for (const k of candidates.sort((i, j) => bounds[j] - bounds[i])) {
    if (bounds[k] < best.speed) break;
    const { length, vertex } = longestDisplacement(makeBlendedPoints(points, k), makeBlendedPoints(points, k + 1));
    const speed = length / (times[k + 1] - times[k]);
    const isFirst = speed === best.speed && times[k] < best.from;
    if (speed > best.speed || isFirst) best = { speed, vertex, from: times[k], to: times[k + 1] };
  }
  return best.from === REST.from ? REST : best;
}

/** For the motion as it is shown, with its bend reduced where it would exceed c. */
function fastestCubic(motion: CubicPointsMotion, c: number, atLeast: number): FastestVertex {
  const { times } = motion;
  let best: FastestVertex = { ...REST, speed: atLeast };
  for (let k = 0; k + 1 < times.length; k++) {
    if (maxControlSpeed(motion, k) <= best.speed) continue;
    const bend = bendFactor(motion, k, c);
    for (let i = 0; 3 * i < motion.points[k].length; i++) {
      if (pointSpeedBound(motion, k, i) <= best.speed) continue;
      const speed = maxPieceSpeed(withBend(pointPiece(motion, k, i), bend), best.speed);
      if (speed > best.speed) best = { speed, vertex: i, from: times[k], to: times[k + 1] };
    }
  }
  return best.from === REST.from ? REST : best;
}
