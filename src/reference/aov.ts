import type { Vec3 } from '../math/vec3.ts';
import { properVelocity } from '../physics/boost.ts';
import { dopplerFactor } from '../physics/doppler.ts';
import type { AovName, RenderSettings } from '../scene/view.ts';
import { lightingOf } from './lighting.ts';
import { DEFAULT_LIGHT } from './lightOptions.ts';
import { openness } from './openness.ts';
import { surfaceAt } from './surface.ts';
import type { TracedScene } from './trace.ts';
import type { Hit, SpacetimeRay } from './types.ts';

export type DataAov = Exclude<AovName, 'beauty'>;

/** What a picture's data say of a hit: as many numbers as `AOVS` has channels. */
export type DataReader = (hit: Hit, ray: SpacetimeRay) => readonly number[];

/** The same numbers for the same picture. */
const NO_CHANCE = (): number => 0;

/** Reads of a camera ray's hit, for an observer with proper velocity u. Without light there is no shift: D = 1. */
export function dataReader(name: DataAov, scene: TracedScene, u: Vec3, settings: RenderSettings): DataReader {
  switch (name) {
    case 'albedo':
      return (hit) => surfaceAt(scene, hit).albedo;
    case 'depth':
      return ({ s }) => [s];
    case 'emission_time':
      return ({ time }) => [time];
    case 'doppler':
      return settings.view === 'light-cone' ? (hit, ray) => [dopplerOf(hit, ray, u)] : () => [1];
    case 'position':
      return ({ position }) => position;
    case 'normal':
      return (hit) => surfaceAt(scene, hit).normal;
    case 'occlusion': {
      const lighting = lightingOf(scene, settings, DEFAULT_LIGHT, u, NO_CHANCE);
      return (hit) => [openness(lighting, hit)];
    }
    case 'velocity':
      return ({ velocity }) => velocity;
    case 'object':
      return ({ object }) => [object + 1];
  }
}

/** D = ν_observed/ν_emitted of what a ray meets, for an observer with proper velocity u where the ray begins. */
export function dopplerOf({ velocity }: Hit, { dx }: SpacetimeRay, u: Vec3): number {
  return dopplerFactor(dx, u, properVelocity(velocity));
}
