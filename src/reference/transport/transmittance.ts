import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import { nearestHit, type TracedScene } from '../intersection/tracedScene.ts';
import { materialOf } from '../materials/material.ts';
import { opacityAt } from '../materials/surface.ts';

/** How much of the light a surface holds back: nothing where it is cut out, and what a cut leaves is solid. */
export function coverage(scene: TracedScene, hit: Hit): number {
  const { opacity, opacityThreshold, baseColorTexture } = materialOf(scene, hit);
  if (!baseColorTexture && opacityThreshold === 0) return opacity;
  const found = opacityAt(scene, hit);
  if (opacityThreshold === 0) return found;
  return found < opacityThreshold ? 0 : 1;
}

/** A ray, where on it things begin to count, and the triangle that it leaves. */
export interface RaySegment {
  readonly ray: SpacetimeRay;
  readonly begin: number;
  readonly from?: Hit;
}

export const isOtherTriangle = ({ from }: RaySegment, { object, corner }: Hit): boolean =>
  !from || object !== from.object || corner !== from.corner;

/** The share of light that gets from s = `end` to the ray's beginning, past all surfaces, each where it was; what is transparent lets through 1 − opacity. */
export function transmittance(scene: TracedScene, beam: RaySegment, end: number): number {
  let share = 1;
  const blocked = nearestHit(scene, beam.ray, {
    begin: beam.begin,
    end,
    accepts: (hit) => {
      if (!isOtherTriangle(beam, hit)) return false;
      const held = coverage(scene, hit);
      share *= 1 - held;
      return held >= 1;
    },
  });
  return blocked ? 0 : share;
}
