import type { Float, Vec3, Vec4, WorldLineAt } from '../types.ts';
import { hyperbolaVertex } from './hyperbola.ts';
import { hyperbolaCrossing } from './hyperbolaCrossing.ts';
import { hyperbolaEvent } from './hyperbolaEvent.ts';

/** World line of a vertex in hyperbolic motion; arguments as in hyperbolicEmission. Position at the time t: the crossing of (t + x∥)/2 + (t − x∥)/2 = t. */
export const hyperbolicPlace =
  (motion: Vec4, w: Float, bornRigid: Float, offset: Vec3): WorldLineAt =>
  (time) => {
    const vertex = hyperbolaVertex(motion, w, bornRigid, offset);
    const eta = hyperbolaCrossing(vertex, w.mul(0.5).toVar(), w.reciprocal().mul(0.5).toVar(), time);
    const { x, velocity } = hyperbolaEvent(motion, w, vertex, eta);
    return { x: x.toVar(), velocity: velocity.toVar() };
  };
