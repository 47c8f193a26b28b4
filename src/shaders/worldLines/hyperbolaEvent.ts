import { max, select, vec4 } from 'three/tsl';
import type { Bool, Float, Vec3, Vec4 } from '../types.ts';
import type { HyperbolaVertex } from './hyperbola.ts';

/** An event of a vertex on its hyperbola, relative to the anchor. */
interface HyperbolaEvent {
  /** [m] */
  readonly x: Vec3;
  /** [light-metres] */
  readonly s: Float;
  /** (v, 1 − v²) */
  readonly velocity: Vec4;
  /** False behind the horizon, and for the part of a Born-rigid body beyond its own horizon. */
  readonly exists: Bool;
}

/**
 * The least e^φ. Light from the edge of the horizon was emitted at e^φ → 0, infinitely far away and long ago; an event at e^φ = 1e-5 is 50,000 c²/a away, within
 * 1e-5 rad of it, and still has digits in f32. Vertices behind the horizon are there too, so that no interpolation meets infinity.
 */
export const MIN_RAPIDITY_FACTOR = 1e-5;

/** The event of the vertex at the parameter `eta` of its hyperbola (see hyperbola.ts). */
export function hyperbolaEvent(motion: Vec4, w: Float, vertex: HyperbolaVertex, eta: Float): HyperbolaEvent {
  const trueGrowth = vertex.acceleration.mul(eta).add(1).toVar();
  const least = w.reciprocal().mul(MIN_RAPIDITY_FACTOR).toVar();
  const growth = max(trueGrowth, least).toVar();
  const limited = select(trueGrowth.lessThan(least), growth.sub(1).div(max(vertex.acceleration, 1e-20)), eta).toVar();
  const plus = w.mul(vertex.plus.add(limited)).toVar();
  const minus = vertex.minus.add(limited.div(growth)).div(w).toVar();
  // e^φ at the event: v = tanh φ, 1 − v² = 1/cosh² φ
  const rapidity = w.mul(growth).toVar();
  const cosh = rapidity.add(rapidity.reciprocal()).mul(0.5).toVar();
  const sinh = rapidity.sub(rapidity.reciprocal()).mul(0.5);
  return {
    x: vertex.across.add(motion.xyz.mul(plus.sub(minus).mul(0.5))),
    s: plus.add(minus).mul(0.5),
    velocity: vec4(motion.xyz.mul(sinh.div(cosh)), cosh.mul(cosh).reciprocal()),
    exists: trueGrowth.greaterThan(0).and(vertex.acceleration.greaterThanEqual(0)),
  };
}
