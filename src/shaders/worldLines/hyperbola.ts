import { dot, select } from 'three/tsl';
import type { Float, Vec3, Vec4 } from '../types.ts';

/** A vertex on a hyperbola, in light-cone coordinates along the axis, boosted to the frame in which the anchor is at rest. */
export interface HyperbolaVertex {
  /** Offset along and across the axis [m]. */
  readonly across: Vec3;
  /** (t + x∥)/w and (t − x∥)·w of the vertex at the event where its rapidity equals the anchor's, relative to the anchor [m]. */
  readonly plus: Float;
  readonly minus: Float;
  /** The vertex's own proper acceleration / c² [1/m]. */
  readonly acceleration: Float;
}

/**
 * Hyperbolic motion about an anchor of rapidity φ_c, w = e^{φ_c}: with ε = e^{φ − φ_c} − 1 = aη the vertex is at
 * t + x∥ = w(plus + η), t − x∥ = (minus + η/(1 + aη))/w, for every a down to 0 (uniform motion). docs/physics.md §4.9.
 * `motion` = (axis, a): unit axis of the proper acceleration, a/c² [1/m] of the object's origin. `bornRigid` 0: every vertex has the origin's
 * acceleration, and `offset` is its offset in the world at one world time; 1: `offset` is its offset in the rest frame, and its own
 * acceleration is a/(1 + a·offset∥) (docs/physics.md §4.5).
 */
export function hyperbolaVertex(motion: Vec4, w: Float, bornRigid: Float, offset: Vec3): HyperbolaVertex {
  const along = dot(offset, motion.xyz).toVar();
  const rigid = bornRigid.greaterThan(0.5);
  return {
    across: offset.sub(motion.xyz.mul(along)).toVar(),
    plus: select(rigid, along, along.div(w)).toVar(),
    minus: select(rigid, along, along.mul(w)).negate().toVar(),
    acceleration: select(rigid, motion.w.div(motion.w.mul(along).add(1)), motion.w).toVar(),
  };
}
