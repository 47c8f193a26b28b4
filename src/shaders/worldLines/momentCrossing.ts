import { dot, select } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../types.ts';
import type { HyperbolaVertex } from './hyperbola.ts';
import { hyperbolaCrossing } from './hyperbolaCrossing.ts';

/**
 * η at which a vertex (see hyperbola.ts) is at the moment γt − u·x = `later` of the observer's frame, relative to the anchor (docs/physics.md §5.3):
 * w(γ − u∥)/2 · (t + x∥)/w + (γ + u∥)/2w · (t − x∥)w = u⊥·x⊥ + later.
 */
export function momentCrossing(
  vertex: HyperbolaVertex,
  motion: Vec4,
  w: Float,
  u: Vec3,
  gamma: Float,
  later: Float | number,
): Float {
  const along = dot(u, motion.xyz).toVar();
  const across = u.sub(motion.xyz.mul(along)).toVar();

  // γ ± u∥, the smaller one in the conjugate form (1 + u⊥²)/(γ + |u∥|)
  const larger = gamma.add(along.abs()).toVar();
  const smaller = dot(across, across).add(1).div(larger).toVar();
  const ahead = along.greaterThan(0);
  const plus = select(ahead, smaller, larger).mul(w).mul(0.5).toVar();
  const minus = select(ahead, larger, smaller).div(w).mul(0.5).toVar();
  return hyperbolaCrossing(vertex, plus, minus, dot(across, vertex.across).add(later));
}
