import { dot, max, select, sqrt } from 'three/tsl';
import type { Float, HyperbolicVertexEvent, Vec3, Vec4 } from '../types.ts';
import { type HyperbolaVertex, hyperbolaVertex } from '../worldLines/hyperbola.ts';
import { hyperbolaEvent } from '../worldLines/hyperbolaEvent.ts';

/**
 * Emission event of a vertex in hyperbolic motion (docs/physics.md §4.9). With T ± x∥ of the vertex relative to the observer, scaled by w (α, κ below), and
 * Q = d² − T² at the event where its rapidity equals the anchor's, η solves (aα − 1)η² + (aQ + α + κ)η + Q = 0 on the increasing branch; the discriminant is
 * (aQ + κ − α)² + 4 d⊥², a sum of squares. No event (behind the horizon) where 1 + aη ≤ 0.
 * `anchor` = (d_c, R) [m]; `motion`, `w` = e^φ at the anchor, `bornRigid`, `offset`: see hyperbola.ts.
 * @example
 * import { float, vec3, vec4 } from 'three/tsl';
 * // It turns 4 m away at this moment, seen on its way out; a/c² = 0.5/m towards the observer.
 * const { dx, exists } = hyperbolicEmission(vec4(0, 0, 4, 4), vec4(0, 0, -1, 0.5), float(1), float(0), vec3(0));
 */
export const hyperbolicEmission = (
  anchor: Vec4,
  motion: Vec4,
  w: Float,
  bornRigid: Float,
  offset: Vec3,
): HyperbolicVertexEvent => hyperbolaEmission(anchor, motion, w, hyperbolaVertex(motion, w, bornRigid, offset));

/** The same for a vertex given by its hyperbola. */
export function hyperbolaEmission(
  anchor: Vec4,
  motion: Vec4,
  w: Float,
  vertex: HyperbolaVertex,
): HyperbolicVertexEvent {
  const along = dot(anchor.xyz, motion.xyz).toVar();
  const across = anchor.xyz.sub(motion.xyz.mul(along)).toVar();

  // R ± d∥ of the anchor, the smaller one in the conjugate form d⊥²/(R + |d∥|)
  const larger = max(anchor.w.add(along.abs()), 1e-20).toVar();
  const smaller = dot(across, across).div(larger).toVar();
  const ahead = along.greaterThan(0);
  const alpha0 = select(ahead, larger, smaller).mul(w).toVar();
  const kappa0 = select(ahead, smaller, larger).div(w).toVar();

  const Q = dot(vertex.across, across.mul(2).add(vertex.across))
    .sub(vertex.plus.mul(vertex.minus))
    .add(vertex.plus.mul(alpha0))
    .add(vertex.minus.mul(kappa0))
    .toVar();
  const alpha = alpha0.sub(vertex.minus).toVar();
  const kappa = kappa0.sub(vertex.plus).toVar();
  const aQ = vertex.acceleration.mul(Q).toVar();
  const B = aQ.add(alpha).add(kappa).toVar();
  const d = across.add(vertex.across).toVar();
  const k = aQ.add(kappa).sub(alpha).toVar();
  const root = sqrt(k.mul(k).add(dot(d, d).mul(4))).toVar();
  const curvature = vertex.acceleration.mul(alpha).sub(1);
  const eta = select(
    B.greaterThan(0),
    Q.mul(-2).div(max(B.add(root), 1e-30)),
    root.sub(B).div(curvature.mul(2)),
  ).toVar();
  const { x, ...event } = hyperbolaEvent(motion, w, vertex, eta);
  return { dx: anchor.xyz.add(x), ...event };
}
