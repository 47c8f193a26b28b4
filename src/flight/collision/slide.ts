import { addScaled, dot, length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { boost } from '../../physics/lorentz/boost.ts';
import { spatial } from '../../physics/lorentz/fourVector.ts';
import type { FlightArc } from '../arc.ts';
import { type Boost, compose, properVelocityOf, relativeBoost } from '../boost.ts';
import { type Wall, worldNormal } from './obstacles.ts';

/**
 * The velocity of what moves into a wall and slides on along it: in the frame where the wall rests the part across it is taken
 * away, and the speed along it stays:
 *
 *     u′_slid = u′_∥ / √(1 + u′_⊥²),  thus β′_slid = β′_∥
 *
 * A wall at rest that is smooth and heavy does no work: energy and momentum along it are conserved, and so is their ratio. What
 * moves away from the wall stays as it is. `wall.normal`: towards the moving body.
 */
export function slideAlong(velocity: Boost, wall: Wall): Boost {
  const own = relativeBoost(velocity, wall.velocity);
  const u = properVelocityOf(own);
  const across = dot(u, wall.normal);
  if (across >= 0) return velocity;
  const along = scale(addScaled(u, wall.normal, -across), 1 / Math.hypot(1, across));
  const slid: Boost = { direction: normalize(along, own.direction), rapidity: Math.asinh(length(along)) };
  return compose(wall.velocity, slid);
}

/** The normal of a wall, towards what moves along it with `velocity`, in the axes of its pushes. */
function ownNormal(velocity: Boost, wall: Wall): Vec3 {
  return normalize(spatial(boost(worldNormal(wall), properVelocityOf(velocity))));
}

/**
 * Arcs of what moves along a wall: of their pushes only what does not lead into it, the rest is the wall's own push back. A
 * constant push along a plane stays in it. `velocity`: that at their beginning.
 */
export function alongWall(arcs: readonly FlightArc[], velocity: Boost, wall: Wall): readonly FlightArc[] {
  return arcs.map((arc) => {
    if (!arc.push) return arc;
    const n = ownNormal(velocity, wall);
    const { direction, size } = arc.push;
    const into = dot(direction, n);
    if (into >= 0) return arc;
    const along = addScaled(direction, n, -into);
    const { push: _, reached: __, ...rest } = arc;
    const part = length(along);
    return part > LEAST_PART ? { ...rest, push: { direction: scale(along, 1 / part), size: size * part } } : rest;
  });
}

/** Less of a push along a wall is rounding. */
const LEAST_PART = 1e-12;
