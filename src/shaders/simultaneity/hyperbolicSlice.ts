import type { Float, HyperbolicVertexEvent, Vec3, Vec4 } from '../types.ts';
import { hyperbolaVertex } from '../worldLines/hyperbola.ts';
import { hyperbolaEvent } from '../worldLines/hyperbolaEvent.ts';
import { momentCrossing } from '../worldLines/momentCrossing.ts';

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
  const eta = momentCrossing(vertex, motion, w, u, gamma, 0);
  const { x, ...event } = hyperbolaEvent(motion, w, vertex, eta);
  return { dx: anchor.xyz.add(x), ...event };
}
