import { add, lerp, type Vec3 } from '../../math/vec3.ts';
import { cubicAt, withBend } from '../../physics/worldLines/cubicPiece.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { pointAt } from '../mesh/polygons.ts';
import { pointsAt, vertexSamples } from '../streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../types.ts';
import { bendFactor, isCubic, pointPiece } from './cubicPoints.ts';
import { pieceAt } from './poses.ts';

/** Vertex → its place at world time t, relative to the motion's origin [m]. c [m/s]. */
export function deformedPoints(motion: SampledPointsMotion, t: number, c: number): (vertex: number) => Vec3 {
  const { before, after, s } = pieceAt(motion.times, t);
  const [a, b] = [pointsAt(motion, before), pointsAt(motion, after)];
  if (!isCubic(motion) || before === after) return (i) => lerp(pointAt(a, i), pointAt(b, i), s);
  const bend = bendFactor(motion, before, c);
  const since = t - motion.times[before];
  return (i) => cubicAt(withBend(pointPiece(motion, before, i), bend), since).x;
}

/** The world line of vertex i, straight or cubic between samples. c [m/s]. */
export function deformedVertexLine(motion: SampledPointsMotion, i: number, c: number): WorldLine {
  const { times } = motion;
  const positions = new Float64Array(3 * times.length);
  const at = vertexSamples(motion, i);
  for (let k = 0; k < times.length; k++) positions.set(add(motion.origin, at(k)), 3 * k);
  if (!isCubic(motion)) return { kind: 'polyline', times, positions };
  const velocities = new Float64Array(6 * (times.length - 1));
  for (let k = 0; k + 1 < times.length; k++) {
    const { va, vb } = withBend(pointPiece(motion, k, i), bendFactor(motion, k, c));
    velocities.set([...va, ...vb], 6 * k);
  }
  return { kind: 'cubic', times, positions, velocities };
}
