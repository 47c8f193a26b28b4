import { addScaled, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { oneMinusBetaSquared } from '../../lorentz/boost.ts';
import { presentEmission } from '../emission.ts';
import { uniformSlice } from '../slice.ts';
import type { WorldLineKind } from './worldLineKind.ts';

/** Constant velocity for all times. */
export interface UniformLine {
  readonly kind: 'uniform';
  /** At t = 0 [m]. */
  readonly position: Vec3;
  /** [m/s], |v| < c. */
  readonly velocity: Vec3;
}

const positionAt = (w: UniformLine, t: number): Vec3 => addScaled(w.position, w.velocity, t);

export const UNIFORM_LINE: WorldLineKind<UniformLine> = {
  positionAt,
  velocityAt: (w) => w.velocity,
  pastLightCone(w, { t, position }, c) {
    const v = scale(w.velocity, 1 / c);
    return presentEmission(sub(positionAt(w, t), position), v, oneMinusBetaSquared(v));
  },
  simultaneitySlice: (w, { t, position }, u, c) =>
    uniformSlice(sub(positionAt(w, t), position), 0, scale(w.velocity, 1 / c), u),
  asInertial: (w) => w,
  asPolyline: () => undefined,
  referencePosition: (w) => w.position,
  hullPoints: () => [],
};
