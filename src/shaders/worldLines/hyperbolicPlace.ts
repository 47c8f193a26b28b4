import type { Float, Vec3, Vec4, WorldLineAt } from '../types.ts';
import { hyperbolaVertex } from './hyperbola.ts';
import { hyperbolaCrossing } from './hyperbolaCrossing.ts';
import { hyperbolaEvent } from './hyperbolaEvent.ts';

/**
 * World line of a vertex in hyperbolic motion; arguments as in hyperbolicEmission. Position at the time t: the crossing of (t + x∥)/2 + (t − x∥)/2 = t.
 * @example
 * import { float, vec3, vec4 } from 'three/tsl';
 * const line = hyperbolicPlace(vec4(0, 0, -1, 0.5), float(1), float(0), vec3(0));
 * const { x } = line(float(2));
 */
export const hyperbolicPlace =
  (motion: Vec4, w: Float, bornRigid: Float, offset: Vec3): WorldLineAt =>
  (time) => {
    const vertex = hyperbolaVertex(motion, w, bornRigid, offset);
    const eta = hyperbolaCrossing(vertex, w.mul(0.5).toVar(), w.reciprocal().mul(0.5).toVar(), time);
    const { x, velocity } = hyperbolaEvent(motion, w, vertex, eta);
    return { x: x.toVar(), velocity: velocity.toVar() };
  };
