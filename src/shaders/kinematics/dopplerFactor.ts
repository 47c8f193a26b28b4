import { Fn, length, max } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../types.ts';
import { emitterDoppler } from './emitterDoppler.ts';
import { observerDoppler } from './observerDoppler.ts';

/**
 * D = ν_observed/ν_emitted = γ_o(1 + β_o·n)/(γ_e(1 + β_e·n)). docs/physics.md §3.4.
 * `dx` [m] observer → emission event; `u`, `gamma` of the observer; `velocity` = (v, 1 − v²) of the emitter there.
 * @example
 * import { float, vec3, vec4 } from 'three/tsl';
 * // A source at 0.6 c away from an observer at rest: D = ½.
 * const D = dopplerFactor(vec3(0, 0, 4), vec3(0), float(1), vec4(0, 0, 0.6, 0.64));
 */
export const dopplerFactor = Fn(
  ([dx, u, gamma, velocity]: [Vec3, Vec3, Float, Vec4]) =>
    observerDoppler(dx, u, gamma).mul(emitterDoppler(dx.div(max(length(dx), 1e-20)), velocity)),
  { dx: 'vec3', u: 'vec3', gamma: 'float', velocity: 'vec4', return: 'float' },
);
