import { materialOf } from './material.ts';
import { opacityAt } from './surface.ts';
import { nearestHit, type TracedScene } from './trace.ts';
import type { Hit, SpacetimeRay } from './types.ts';

/** Blended surfaces count, or only those that hide what is behind them. */
export type Transparent = 'hit' | 'skip';

/**
 * What a picture shows on a ray: the nearest front side, or back side where the mesh is double sided, without what is cut out.
 * Data of a picture are of what hides the rest, so transparent surfaces are skipped there.
 */
export function visibleHit(scene: TracedScene, ray: SpacetimeRay, transparent: Transparent = 'skip'): Hit | undefined {
  const accepts = (hit: Hit): boolean => isThere(scene, hit, transparent);
  return nearestHit(scene, ray, { shown: true, unasked: scene.solid, accepts });
}

/** Whether any of the surface is left at a hit. */
function isThere(scene: TracedScene, hit: Hit, transparent: Transparent): boolean {
  const material = materialOf(scene, hit);
  if (scene.transparent.has(material)) return transparent === 'hit';
  return material.opacityThreshold === 0 || opacityAt(scene, hit) >= material.opacityThreshold;
}
