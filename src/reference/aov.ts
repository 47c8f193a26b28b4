import type { Vec3 } from '../math/vec3.ts';
import { properVelocity } from '../physics/lorentz/boost.ts';
import { dopplerFactor } from '../physics/optics/doppler.ts';
import type { DataAov, RenderSettings } from '../scene/view/view.ts';
import { isLuminous } from '../scene/views/views.ts';
import { type Hit, lightOf, type SpacetimeRay } from './acceleration/ray.ts';
import type { TracedScene } from './intersection/tracedScene.ts';
import { createLightingContext } from './lights/createLightingContext.ts';
import { DEFAULT_LIGHT } from './lights/lightOptions.ts';
import { surfaceAt } from './materials/surface.ts';
import { openness } from './transport/openness.ts';

/** Returns a hit's values of one AOV: as many as `AOVS` lists channels. */
export type AovReader = (hit: Hit, ray: SpacetimeRay) => readonly number[];

/** Makes the data of a picture reproducible. */
const ZERO_RANDOM = (): number => 0;

/** The reader of an AOV, for hits of camera rays of an observer with proper velocity u. In views without light D = 1. */
export function aovReader(name: DataAov, scene: TracedScene, u: Vec3, settings: RenderSettings): AovReader {
  switch (name) {
    case 'albedo':
      return (hit) => surfaceAt(scene, hit).albedo;
    case 'depth':
      return ({ s }) => [s];
    case 'emission_time':
      return ({ time }) => [time];
    case 'emission_time_relative':
      return ({ time }, ray) => [time - ray.t];
    case 'doppler':
      return isLuminous(settings) ? (hit, ray) => [dopplerOfHit(hit, ray, u)] : () => [1];
    case 'position':
      return ({ position }) => position;
    case 'normal':
      return (hit) => surfaceAt(scene, hit).normal;
    case 'roughness':
      return (hit) => [surfaceAt(scene, hit).roughness];
    case 'metallic':
      return (hit) => [surfaceAt(scene, hit).metallic];
    case 'occlusion': {
      const lighting = createLightingContext(scene, settings, DEFAULT_LIGHT, u, ZERO_RANDOM);
      return (hit) => [openness(lighting, hit)];
    }
    case 'velocity':
      return ({ velocity }) => velocity;
    case 'object':
      return ({ object }) => [object + 1];
  }
}

/**
 * D = ν_observed/ν_emitted of a ray's hit, for an observer with proper velocity u at the ray's origin.
 * @example
 * import { makeObject, makeScene, plane, restingAt } from 'slowlight/scene';
 * const wall = makeObject({ path: '/Wall', mesh: plane(2, 2), motion: restingAt([0, 0, -4]) });
 * const scene = createTracedScene(makeScene({ name: 'wall', objects: [wall] }), 10);
 * const ray = { t: 0, x: [0, 0, 0], dt: -1, dx: [0, 0, -1] } as const;
 * // The observer flies towards it at 0.6 c.
 * dopplerOfHit(visibleHit(scene, ray)!, ray, [0, 0, -0.75]); // 2
 */
export function dopplerOfHit(hit: Hit, ray: SpacetimeRay, u: Vec3): number {
  return dopplerFactor(lightOf(ray, hit).dx, u, properVelocity(hit.velocity));
}
