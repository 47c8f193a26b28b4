import type { Float, Vec3 } from '../types.ts';

/** An observer and his cone ct′ = −λr′, 0 < λ < 1. */
export interface ShallowObserver {
  /** γβ and γ. */
  readonly u: Vec3;
  readonly gamma: Float;
  /** λ */
  readonly coneSlope: Float;
  /** γβ and γ of the velocity λβ (`slowed` of src/physics/worldLines/shallowCone.ts). */
  readonly slowedU: Vec3;
  readonly slowedGamma: Float;
}
