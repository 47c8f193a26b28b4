import type { Mesh } from '../../../../scene/types.ts';
import { numbersAt } from '../../layer/attributes.ts';
import type { NumberArray, PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import type { DeformedPoints, PrimGeometry } from '../geometry/primGeometry.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import type { MeshPiece } from './meshPieces.ts';

/** The mesh of a piece with its motion while it lives; `pointsFor` maps the prim's points at a time to its vertices. */
export function pieceGeometry(
  { codesPerSecond }: Pick<StageContext, 'codesPerSecond'>,
  prim: PrimSpec,
  mesh: Mesh,
  { codes, after, end }: MeshPiece,
  pointsFor: (points: ArrayLike<number>, time: number) => DeformedPoints,
): PrimGeometry {
  const last = codes[codes.length - 1];
  const times = after === 'rest' ? codes : unionOfTimes([codes, Float64Array.of(end)]);
  if (times.length < 2) return { mesh };
  const pointsAt = (time: number): ArrayLike<number> => {
    if (time <= last || after === 'straight') return pointsOf(prim, time);
    const points = pointsOf(prim, last);
    return after === 'rest'
      ? points
      : movedPoints(points, numbersAt(prim, 'velocities', last)!, (time - last) / codesPerSecond);
  };
  const at = (time: number): DeformedPoints => {
    const placed = pointsFor(pointsAt(time), Math.min(time, last));
    // Of one sample, the normals keep their directions while the points move on.
    return codes.length === 1 && after === 'velocities' ? { ...placed, normals: mesh.normals.slice() } : placed;
  };
  return { mesh, deformation: { times, at } };
}

const pointsOf = (prim: PrimSpec, time: number): NumberArray => numbersAt(prim, 'points', time)!;

const movedPoints = (points: NumberArray, velocities: NumberArray, seconds: number): Float64Array =>
  Float64Array.from(points, (x, i) => x + velocities[i] * seconds);

/** A transform as far as a piece needs it: between its birth and its death. */
export function transformInLife(frame: StageTransform, { from, until }: MeshPiece): StageTransform {
  if (frame.times.length === 0) return frame;
  const within = frame.times.filter((time) => time > from && time < until);
  const times = Float64Array.from([
    ...(Number.isFinite(from) ? [from] : []),
    ...within,
    ...(Number.isFinite(until) ? [until] : []),
  ]);
  return { ...frame, times: times.length > 0 ? times : frame.times };
}
