import { int, Loop, length, max } from 'three/tsl';
import { coneOffset } from '../kinematics/coneOffset.ts';
import { recession } from '../kinematics/recession.ts';
import type { Float, Int, Vec4, VertexEvent, WorldLineAt } from '../types.ts';

/**
 * The emission event by damped Newton steps t ← t − k f/f′, started at the observer's time, with f = |x| − R + t and
 * f′ = 1 + v·n. For comparison with the exact solvers: with few steps it shows the errors of a naive program. docs/physics.md §4.11.
 * `anchor` = (d_c, R) [m] is on the past light cone; `line` is made by one of the …Place functions; `damping` is k, 0 < k ≤ 1.
 * @example
 * import { float, int, vec3, vec4 } from 'three/tsl';
 * const line = uniformPlace(vec4(0.6, 0, 0, 0.64), vec3(0, 0.5, 0));
 * const { dx } = newtonEmission(vec4(0, 0, -4, 4), line, int(5), float(1));
 */
export function newtonEmission(anchor: Vec4, line: WorldLineAt, iterations: Int, damping: Float): VertexEvent {
  const time = anchor.w.toVar();
  Loop({ start: int(0), end: iterations, type: 'int', condition: '<' }, () => {
    const { x, velocity } = line(time);
    const dx = anchor.xyz.add(x).toVar();
    const n = dx.div(max(length(dx), 1e-20)).toVar();
    const miss = coneOffset(anchor, x).add(time);
    time.subAssign(damping.mul(miss).div(recession(n, velocity)));
  });
  const { x, velocity } = line(time);
  return { dx: anchor.xyz.add(x), s: time, velocity };
}
