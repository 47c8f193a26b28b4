import { Fn, length, max, vec4 } from 'three/tsl';
import type { Vec4 } from '../types.ts';

/** (v, 1 − v²) between two samples (x, y, z, t): 1 − v² = (Δt − |Δx|)(Δt + |Δx|)/Δt². */
export const pieceVelocity = Fn(
  ([a, b]: [Vec4, Vec4]): Vec4 => {
    const delta = b.sub(a).toVar();
    const dt = max(delta.w, 1e-30).toVar();
    const l = length(delta.xyz).toVar();
    return vec4(delta.xyz.div(dt), dt.sub(l).mul(dt.add(l)).div(dt.mul(dt)));
  },
  { a: 'vec4', b: 'vec4', return: 'vec4' },
);
