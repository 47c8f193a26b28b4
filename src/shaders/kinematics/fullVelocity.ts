import { length, vec4 } from 'three/tsl';
import type { Vec3, Vec4 } from '../types.ts';

/** (v, 1 − v²), the second from (1 − |v|)(1 + |v|): its rounding is that of v, however near to c. */
export function fullVelocity(v: Vec3): Vec4 {
  const speed = length(v).toVar();
  return vec4(v, speed.oneMinus().mul(speed.add(1)));
}
