import { addScaled, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { hyperbolicEmission } from '../emission.ts';
import { hyperbolicSlice } from '../slice.ts';
import type { WorldLineKind } from './worldLineKind.ts';

/** Constant proper acceleration for all times, momentarily at rest at t0. Zero acceleration means at rest. */
export interface HyperbolicLine {
  readonly kind: 'hyperbolic';
  /** At t0 [m]. */
  readonly position: Vec3;
  /** [m/s²] */
  readonly properAcceleration: Vec3;
  /** [s] */
  readonly t0: number;
}

/** ℓ(√(1 + (as/c)²) − 1) â = as²/(1 + √(1 + (as/c)²)), without cancellation; s = t − t0. docs/physics.md §4.4. */
function positionAt(w: HyperbolicLine, t: number, c: number): Vec3 {
  const s = t - w.t0;
  const a = w.properAcceleration;
  return addScaled(w.position, a, (s * s) / (1 + Math.hypot(1, (Math.hypot(...a) * s) / c)));
}

export const HYPERBOLIC_LINE: WorldLineKind<HyperbolicLine> = {
  positionAt,
  velocityAt(w, t, c) {
    const s = t - w.t0;
    const a = w.properAcceleration;
    return scale(a, s / Math.hypot(1, (Math.hypot(...a) * s) / c));
  },
  properVelocityAt: ({ properAcceleration, t0 }, t, c) => scale(properAcceleration, (t - t0) / c),
  pastLightCone: (w, { t, position }, c) =>
    hyperbolicEmission(sub(w.position, position), c * (t - w.t0), scale(w.properAcceleration, 1 / (c * c))),
  simultaneitySlice: (w, { t, position }, u, c) =>
    hyperbolicSlice(sub(w.position, position), c * (t - w.t0), scale(w.properAcceleration, 1 / (c * c)), u),
  asInertial: () => undefined,
  asPolyline: () => undefined,
  referencePosition: (w) => w.position,
  // It moves along a straight line and turns at t0.
  hullPoints: (w, from, to, c) => (from < w.t0 && w.t0 < to ? [positionAt(w, w.t0, c)] : []),
};
