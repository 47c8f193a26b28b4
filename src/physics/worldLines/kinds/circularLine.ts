import { fromAxisAngle, rotate } from '../../../math/quat.ts';
import { add, addScaled, cross, dot, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { circularEmission } from '../emission.ts';
import { circularSlice } from '../slice.ts';
import type { WorldLineKind } from './worldLineKind.ts';

/** Circular motion at constant speed. */
export interface CircularLine {
  readonly kind: 'circular';
  /** [m] */
  readonly center: Vec3;
  /** Unit; the rotation is right-handed about it. */
  readonly axis: Vec3;
  /** From the centre to the point at t = 0 [m]. */
  readonly arm: Vec3;
  /** [rad/s], |ω| |arm| < c. */
  readonly angularVelocity: number;
}

const armAt = (w: CircularLine, t: number): Vec3 => rotate(fromAxisAngle(w.axis, w.angularVelocity * t), w.arm);

/** The centre of the circle itself, which includes the axial part of the arm, and the arm at t, perpendicular to the axis [m]. */
export function circleAt(w: CircularLine, t: number): { readonly center: Vec3; readonly arm: Vec3 } {
  const turning = addScaled(w.arm, w.axis, -dot(w.arm, w.axis));
  return {
    center: add(w.center, sub(w.arm, turning)),
    arm: rotate(fromAxisAngle(w.axis, w.angularVelocity * t), turning),
  };
}

/** The corners of the square around the circle. */
function squareCorners(w: CircularLine): readonly Vec3[] {
  const { center, arm } = circleAt(w, 0);
  const across = cross(w.axis, arm);
  return [arm, scale(arm, -1)].flatMap((x) => [add(center, add(x, across)), add(center, sub(x, across))]);
}

export const CIRCULAR_LINE: WorldLineKind<CircularLine> = {
  positionAt: (w, t) => add(w.center, armAt(w, t)),
  velocityAt: (w, t) => scale(cross(w.axis, armAt(w, t)), w.angularVelocity),
  pastLightCone(w, { t, position }, c) {
    const { center, arm } = circleAt(w, t);
    return circularEmission(sub(center, position), w.axis, arm, w.angularVelocity / c);
  },
  simultaneitySlice(w, { t, position }, u, c) {
    const { center, arm } = circleAt(w, t);
    return circularSlice(sub(center, position), w.axis, arm, w.angularVelocity / c, u);
  },
  asInertial: () => undefined,
  asPolyline: () => undefined,
  referencePosition: (w) => add(w.center, w.arm),
  hullPoints: squareCorners,
};
