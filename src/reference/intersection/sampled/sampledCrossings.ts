import { addScaled, cross, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { contraction } from '../../../physics/worldLines/simultaneity.ts';
import type { Hit, SpacetimeRay } from '../../acceleration/ray.ts';
import { type Crossing, createHit, type ObjectIntersector, type RayQuery } from '../../acceleration/rayQuery.ts';
import type { SpacetimeTriangle } from './spacetimeTriangle.ts';

/** Rounding error of corners relative to the ray, in units of the last place. */
const ROUNDINGS = 32;

/** Accuracy of positions relative to o, of an object whose greatest absolute coordinate is `reach` [m]. */
export const positionNoise = (o: ArrayLike<number>, reach: number): number =>
  ROUNDINGS * Number.EPSILON * (Math.abs(o[0]) + Math.abs(o[1]) + Math.abs(o[2]) + reach);

/** Offers the crossings of the ray with a triangle between s = `from` and `from` + `length`, until the search takes one. */
export function offerCrossings(
  search: RayQuery,
  tracer: ObjectIntersector,
  triangle: SpacetimeTriangle,
  from: number,
  length: number,
  noise: number,
  corner: number,
  piece: number,
): void {
  const n = triangle.intersect(length, noise);
  for (let j = 0; j < n; j++) {
    const s = from + triangle.sigma[j];
    if (search.offer(tracer, s, corner, triangle.v[j], triangle.w[j], triangle.front[j], piece)) break;
  }
}

/** Place [m] and velocity [m/s] of a vertex. */
export interface MovingVertex {
  readonly place: Vec3;
  readonly velocity: Vec3;
}

/** The hit of a crossing with a triangle whose vertices move so. c [m/s]. */
export function hitOfVertices(
  ray: SpacetimeRay,
  object: number,
  crossing: Crossing,
  c: number,
  [p, q, r]: readonly MovingVertex[],
): Hit {
  const { v, w } = crossing;
  const firstTwo = addScaled(scale(p.velocity, 1 - v - w), q.velocity, v);
  const velocity = scale(addScaled(firstTwo, r.velocity, w), 1 / c);
  const plane = cross(sub(q.place, p.place), sub(r.place, p.place));
  return createHit(ray, object, crossing, c, velocity, contraction(plane, properVelocity(velocity)));
}
