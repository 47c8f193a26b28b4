import { add, addScaled, dot, length, negate, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import { quadricOf } from '../../scene/mesh/quadric.ts';
import { objectPoint } from '../../scene/mesh/stretch.ts';
import type { Hit } from '../acceleration/ray.ts';
import { motionTracer } from '../intersection/motionTracers.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';
import type { RayOrigin } from '../lights/lightingContext.ts';
import { faceForward, facingNormal, verticesOf } from '../materials/surface.ts';

/** Origin of rays that leave a surface. */
export interface SurfaceOrigin extends RayOrigin {
  /** The triangle that they leave, which they do not hit again. */
  readonly hit: Hit;
  /** The triangle's normal on the side of the rays, in the rest frame. */
  readonly geometricNormal: Vec3;
}

/**
 * Triangles that approximate a curved body would be shadowed by neighbours that stick out (the shadow terminator). Rays therefore begin on the curved
 * surface implied by the vertex normals: the projections onto the corners' tangent planes, weighted barycentrically. On flat faces, and on round solids, this is the hit.
 * Source: Hanika 2021, "Hacking the shadow terminator", Ray Tracing Gems II, ch. 4.
 */
export function reflectionOrigin(scene: TracedScene, hit: Hit): SurfaceOrigin {
  const object = scene.objects[hit.object];
  if (quadricOf(object)) return { ...transmissionOrigin(scene, hit), geometricNormal: facingNormal(hit) };
  const corners = verticesOf(scene, hit);
  const place = motionTracer(object.motion).vertexPlaces(object, hit.time, scene.c);
  const normal = motionTracer(object.motion).vertexNormals(object, hit.time);
  const [a, b, c] = corners.indices.map(place);
  const [p, q, r] = corners.weights;
  const here = add(add(scale(a, p), scale(b, q)), scale(c, r));
  let out: Vec3 = [0, 0, 0];
  [a, b, c].forEach((corner, k) => {
    const n = faceForward(facingNormal(hit), normal(corners.indices[k]));
    const under = Math.min(0, dot(sub(here, corner), n)) / Math.max(dot(n, n), 1e-12);
    out = addScaled(out, n, -under * corners.weights[k]);
  });
  const contracted = object.authoredIn === 'rest' ? contraction(out, properVelocity(hit.velocity)) : out;
  return {
    t: hit.time,
    x: add(hit.position, contracted),
    clearance: clearanceAt(scene, hit),
    hit,
    geometricNormal: facingNormal(hit),
  };
}

/** The hit itself, for rays that continue behind the surface. */
export const transmissionOrigin = (scene: TracedScene, hit: Hit): SurfaceOrigin => ({
  t: hit.time,
  x: hit.position,
  clearance: clearanceAt(scene, hit),
  hit,
  geometricNormal: negate(facingNormal(hit)),
});

/** Well above the f64 rounding of positions, and of times multiplied by the surface's speed [m]. */
function clearanceAt({ objects, c }: TracedScene, { object, corner, position, time, velocity }: Hit): number {
  const { indices } = objects[object].mesh;
  const [a, b] = [indices[corner], indices[corner + 1]].map((vertex) => objectPoint(objects[object], vertex));
  const size = length(position) + length(a) + length(b);
  return 1e-10 * size + 1e-13 * c * Math.abs(time) * length(velocity);
}
