import type { Material } from '../scene/types.ts';
import { nearestHit, type TracedScene } from './trace.ts';
import type { Hit, SpacetimeRay } from './types.ts';

/** Blended surfaces count, or only those that hide what is behind them. */
export type Transparent = 'hit' | 'skip';

/**
 * What a picture shows on a ray: the nearest front side, or back side where the mesh is double sided, without what is cut out.
 * Data of a picture are of what hides the rest, so transparent surfaces are skipped there.
 */
export function visibleHit(scene: TracedScene, ray: SpacetimeRay, transparent: Transparent = 'skip'): Hit | undefined {
  return nearestHit(scene, ray, { accepts: (hit) => isShown(scene, hit, transparent) });
}

/** Whether a surface is there for who looks at it from where the ray comes. */
export function isShown(scene: TracedScene, hit: Hit, _transparent: Transparent): boolean {
  return hit.front || scene.objects[hit.object].mesh.doubleSided;
}

/** The material of the triangle that is hit. */
export function materialOf({ scene, objects }: TracedScene, { object, corner }: Hit): Material {
  const group = objects[object].mesh.groups.find(({ start, count }) => corner >= start && corner < start + count);
  return scene.materials[group?.material ?? 0];
}
