import { quadricOf } from '../../scene/mesh/quadric.ts';
import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import { nearestHit, type TracedScene } from '../intersection/tracedScene.ts';
import { materialOf } from '../materials/material.ts';
import { opacityAt } from '../materials/surface.ts';

/** The opacity at a hit; with an opacity threshold 0 below it, otherwise 1. */
export function coverage(scene: TracedScene, hit: Hit): number {
  const { opacity, opacityThreshold, baseColorTexture } = materialOf(scene, hit);
  if (!baseColorTexture && opacityThreshold === 0) return opacity;
  const found = opacityAt(scene, hit);
  if (opacityThreshold === 0) return found;
  return found < opacityThreshold ? 0 : 1;
}

/** A ray, the s from which hits count, and the triangle that it leaves. */
export interface RaySegment {
  readonly ray: SpacetimeRay;
  readonly begin: number;
  readonly from?: Hit;
}

/** Whether a hit is elsewhere than the ray begins. A round solid, which is convex, is not met again but from inside, maybe on the same triangle. */
export const isElsewhere = ({ objects }: TracedScene, { from }: RaySegment, { object, corner }: Hit): boolean =>
  !from || object !== from.object || corner !== from.corner || quadricOf(objects[object]) !== undefined;

/** What lies on the way of light: the fraction that transparent surfaces transmit, 0 if an opaque one blocks it, and the transmissive ones that it passes. */
export interface Visibility {
  readonly fraction: number;
  /** From the ray's beginning on. */
  readonly glass: readonly Hit[];
}

/** The fraction of light transmitted from s = `end` to the ray's beginning, past all surfaces, each where the light passed it; transparent ones transmit 1 − opacity. */
export function visibility(scene: TracedScene, beam: RaySegment, end: number): Visibility {
  let transmitted = 1;
  const glass: Hit[] = [];
  const blocked = nearestHit(scene, beam.ray, {
    begin: beam.begin,
    end,
    any: true,
    accepts: (hit) => {
      if (!isElsewhere(scene, beam, hit)) return false;
      if (materialOf(scene, hit).transmission) {
        glass.push(hit);
        return false;
      }
      const opacity = coverage(scene, hit);
      transmitted *= 1 - opacity;
      return opacity >= 1;
    },
  });
  return { fraction: blocked ? 0 : transmitted, glass: glass.sort((a, b) => a.s - b.s) };
}
