import { cross, dot, Fn, select } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../types.ts';

/**
 * 1 + v·n, in conjugate form ((1 − v²) + |v×n|²)/(1 − v·n) where the source approaches.
 * `n` unit, observer → source; `velocity` = (v, 1 − v²) of the source.
 */
export const recession = Fn(
  ([n, velocity]: [Vec3, Vec4]): Float => {
    const along = dot(velocity.xyz, n).toVar();
    const across = cross(velocity.xyz, n).toVar();
    const approaching = velocity.w.add(dot(across, across)).div(along.oneMinus());
    return select(along.lessThan(0), approaching, along.add(1));
  },
  { n: 'vec3', velocity: 'vec4', return: 'float' },
);
