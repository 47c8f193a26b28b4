import { Fn, max, sqrt } from 'three/tsl';
import type { Vec3, Vec4 } from '../types.ts';
import { recession } from './recession.ts';

/**
 * D_e = 1/(γ_e(1 + v·n)), the factor of the source's motion. `n` unit, observer → source; `velocity` = (v, 1 − v²).
 * @example
 * import { vec3, vec4 } from 'three/tsl';
 * const D = emitterDoppler(vec3(0, 0, 1), vec4(0, 0, 0.6, 0.64));
 */
export const emitterDoppler = Fn(
  ([n, velocity]: [Vec3, Vec4]) => sqrt(max(velocity.w, 0)).div(recession(n, velocity)),
  { n: 'vec3', velocity: 'vec4', return: 'float' },
);
