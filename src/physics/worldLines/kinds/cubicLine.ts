import { addScaled, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { type CubicPiece, cubicAt, cubicCrossing, cubicEmission } from '../cubicPiece.ts';
import { type SampledLine, samplePosition, samplesUntil } from '../samples.ts';
import { relativeTime, sampledLine } from './sampledLine.ts';
import type { ObserverEvent, WorldLineKind } from './worldLineKind.ts';

/** Cubic pieces between samples. */
export interface CubicLine extends SampledLine {
  readonly kind: 'cubic';
  /** 6 per piece: its velocities at the start and the end [m/s]. All control velocities (`controlVelocities`) are below c. */
  readonly velocities: Float64Array;
}

/** The piece between samples i and i + 1. */
export function cubicPiece(w: CubicLine, i: number): CubicPiece {
  const velocity = (k: number): Vec3 => [w.velocities[k], w.velocities[k + 1], w.velocities[k + 2]];
  return {
    a: samplePosition(w, i),
    va: velocity(6 * i),
    b: samplePosition(w, i + 1),
    vb: velocity(6 * i + 3),
    span: w.times[i + 1] - w.times[i],
  };
}

/** The piece in relative form: c = 1, positions relative to the observer's, times in metres of light. c [m/s]. */
function relativePiece(w: CubicLine, i: number, { position }: ObserverEvent, c: number): CubicPiece {
  const { a, va, b, vb, span } = cubicPiece(w, i);
  return { a: sub(a, position), va: scale(va, 1 / c), b: sub(b, position), vb: scale(vb, 1 / c), span: c * span };
}

/** The Bézier control points of the pieces between two times. */
function controlPoints(w: CubicLine, from: number, to: number): readonly Vec3[] {
  const end = Math.min(w.times.length - 1, samplesUntil(w.times, to));
  const points: Vec3[] = [];
  for (let i = Math.max(0, samplesUntil(w.times, from) - 1); i < end; i++) {
    const { a, va, b, vb, span } = cubicPiece(w, i);
    points.push(a, addScaled(a, va, span / 3), addScaled(b, vb, -span / 3), b);
  }
  return points;
}

export const CUBIC_LINE: WorldLineKind<CubicLine> = {
  ...sampledLine<CubicLine>({
    positionAt: (w, i, t) => cubicAt(cubicPiece(w, i), t - w.times[i]).x,
    velocityAt: (w, i, t) => cubicAt(cubicPiece(w, i), t - w.times[i]).v,
    pastLightCone: (w, i, observer, c) =>
      cubicEmission(relativePiece(w, i, observer, c), relativeTime(w, i, observer, c)),
    simultaneitySlice(w, i, observer, u, c) {
      const piece = relativePiece(w, i, observer, c);
      const tA = relativeTime(w, i, observer, c);
      const s = cubicCrossing(piece, tA, u);
      return { offset: cubicAt(piece, s).x, ahead: tA + s };
    },
  }),
  asPolyline: () => undefined,
  hullPoints: controlPoints,
};
