import { dot, select } from 'three/tsl';
import type { Float, HyperbolicVertexEvent, Vec3, Vec4 } from '../types.ts';
import { hyperbolaVertex } from '../worldLines/hyperbola.ts';
import { hyperbolaCrossing } from '../worldLines/hyperbolaCrossing.ts';
import { hyperbolaEvent } from '../worldLines/hyperbolaEvent.ts';

/**
 * The event of a vertex in hyperbolic motion on the observer's slice Δt′ = 0 (docs/physics.md §5.3): u·x = γt, that is
 * w(γ − u∥)/2 · (t + x∥)/w + (γ + u∥)/2w · (t − x∥)w = u⊥·x⊥. `anchor` = (d_c, R) is an event of the slice; the rest as in
 * hyperbolicEmission. u = 0: the slice of world time.
 * @example
 * import { float, vec3, vec4 } from 'three/tsl';
 * const { dx } = hyperbolicSlice(
 *   vec4(0, 0, 4, 4),
 *   vec4(0, 0, -1, 0.5),
 *   float(1),
 *   float(0),
 *   vec3(0.5, 0, 0),
 *   vec3(0),
 *   float(1),
 * );
 */
export function hyperbolicSlice(
  anchor: Vec4,
  motion: Vec4,
  w: Float,
  bornRigid: Float,
  offset: Vec3,
  u: Vec3,
  gamma: Float,
): HyperbolicVertexEvent {
  const vertex = hyperbolaVertex(motion, w, bornRigid, offset);
  const along = dot(u, motion.xyz).toVar();
  const across = u.sub(motion.xyz.mul(along)).toVar();

  // γ ± u∥, the smaller one in the conjugate form (1 + u⊥²)/(γ + |u∥|)
  const larger = gamma.add(along.abs()).toVar();
  const smaller = dot(across, across).add(1).div(larger).toVar();
  const ahead = along.greaterThan(0);
  const plus = select(ahead, smaller, larger).mul(w).mul(0.5).toVar();
  const minus = select(ahead, larger, smaller).div(w).mul(0.5).toVar();

  const eta = hyperbolaCrossing(vertex, plus, minus, dot(across, vertex.across));
  const { x, ...event } = hyperbolaEvent(motion, w, vertex, eta);
  return { dx: anchor.xyz.add(x), ...event };
}
