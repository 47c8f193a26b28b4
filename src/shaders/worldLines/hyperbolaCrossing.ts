import { max, select, sqrt } from 'three/tsl';
import type { Float } from '../types.ts';
import type { HyperbolaVertex } from './hyperbola.ts';

/**
 * η at which the vertex (see hyperbola.ts) crosses the spacelike hyperplane A₊(t + x∥)/w + A₋(t − x∥)w = h, A₊ and A₋ > 0:
 * aA₊η² + (A₊ + A₋ − ak)η − k = 0, k = h − A₊·plus − A₋·minus; the discriminant is (A₊ − A₋ + ak)² + 4A₊A₋. There always is exactly one.
 */
export function hyperbolaCrossing(vertex: HyperbolaVertex, aPlus: Float, aMinus: Float, h: Float): Float {
  const k = h.sub(aPlus.mul(vertex.plus)).sub(aMinus.mul(vertex.minus)).toVar();
  const ak = vertex.acceleration.mul(k).toVar();
  const B = aPlus.add(aMinus).sub(ak).toVar();
  const difference = aPlus.sub(aMinus).add(ak).toVar();
  const root = sqrt(difference.mul(difference).add(aPlus.mul(aMinus).mul(4))).toVar();
  const late = root.sub(B).div(aPlus.mul(vertex.acceleration).mul(2));
  return select(B.greaterThan(0), k.mul(2).div(max(B.add(root), 1e-30)), late).toVar();
}
