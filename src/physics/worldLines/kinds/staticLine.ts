import { sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { staticEmission } from '../emission.ts';
import { uniformSlice } from '../slice.ts';
import type { WorldLineKind } from './worldLineKind.ts';

/** A point at rest. */
export interface StaticLine {
  readonly kind: 'static';
  /** [m] */
  readonly position: Vec3;
}

export const STATIC_LINE: WorldLineKind<StaticLine> = {
  positionAt: (w) => w.position,
  velocityAt: () => ZERO,
  pastLightCone: (w, { position }) => staticEmission(sub(w.position, position)),
  simultaneitySlice: (w, { position }, u) => uniformSlice(sub(w.position, position), 0, ZERO, u),
  asInertial: ({ position }) => ({ position, velocity: ZERO }),
  asPolyline: () => undefined,
  referencePosition: (w) => w.position,
  hullPoints: () => [],
};
