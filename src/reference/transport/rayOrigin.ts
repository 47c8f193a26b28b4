import { add, addScaled, dot, length, negate, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import type { Hit } from '../acceleration/ray.ts';
import { motionTracer } from '../intersection/motionTracers.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';
import type { RayOrigin } from '../lights/lightingContext.ts';
import { faceForward, facingNormal, verticesOf } from '../materials/surface.ts';

/** Where rays leave a surface on the side from which it is looked at. */
export interface SurfaceOrigin extends RayOrigin {
  /** The triangle that they leave, and do not meet again. */
  readonly hit: Hit;
  /** The triangle's own normal on that side, in the rest frame. */
  readonly geometricNormal: Vec3;
}

/**
 * Triangles that stand for a round body shade it where their neighbours stick out of them. Rays therefore begin on the curved surface that
 * the corners' normals tell of: each corner's tangent plane, weighted as the corner is. On flat faces this is the hit itself.
 * Source: Hanika 2021, "Hacking the shadow terminator", Ray Tracing Gems II, ch. 4.
 */
export function reflectionOrigin(scene: TracedScene, hit: Hit): SurfaceOrigin {
  const corners = verticesOf(scene, hit);
  const object = scene.objects[hit.object];
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

/** The hit itself, for rays that go on behind the surface. */
export const transmissionOrigin = (scene: TracedScene, hit: Hit): SurfaceOrigin => ({
  t: hit.time,
  x: hit.position,
  clearance: clearanceAt(scene, hit),
  hit,
  geometricNormal: negate(facingNormal(hit)),
});

/** Well above the rounding of f64 of places, and of times times the surface's speed [m]. */
function clearanceAt({ objects, c }: TracedScene, { object, corner, position, time, velocity }: Hit): number {
  const { positions, indices } = objects[object].mesh;
  const [a, b] = [pointAt(positions, indices[corner]), pointAt(positions, indices[corner + 1])];
  const size = length(position) + length(a) + length(b);
  return 1e-10 * size + 1e-13 * c * Math.abs(time) * length(velocity);
}
