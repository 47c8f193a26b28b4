import { dot, int, Loop, max } from 'three/tsl';
import type { Float, Int, Vec3, Vec4, VertexEvent, WorldLineAt } from '../types.ts';

/**
 * The event with Δt′ = 0 by damped Newton steps t ← t − k f/f′, started at the observer's time, with f = t − β·x and f′ = 1 − β·v. For comparison
 * with the exact solvers, as `newtonEmission`. docs/physics.md §5.6.
 * `anchor` = (d_c, |d_c|) [m] is in the slice; `line` is made by one of the …Place functions; `damping` is k, 0 < k ≤ 1.
 * @example
 * import { float, int, vec3, vec4 } from 'three/tsl';
 * const line = uniformPlace(vec4(0.6, 0, 0, 0.64), vec3(0, 0.5, 0));
 * const { dx } = newtonSlice(vec4(0, 0, -4, 4), line, vec3(0, 0, 0.75), float(1.25), int(5), float(1));
 */
export function newtonSlice(
  anchor: Vec4,
  line: WorldLineAt,
  u: Vec3,
  gamma: Float,
  iterations: Int,
  damping: Float,
): VertexEvent {
  const beta = u.div(gamma).toVar();
  const time = dot(beta, anchor.xyz).negate().toVar();
  Loop({ start: int(0), end: iterations, type: 'int', condition: '<' }, () => {
    const { x, velocity } = line(time);
    const slope = max(dot(beta, velocity.xyz).oneMinus(), 1e-7);
    time.subAssign(damping.mul(time.sub(dot(beta, x))).div(slope));
  });
  const { x, velocity } = line(time);
  return { dx: anchor.xyz.add(x), s: time, velocity };
}
