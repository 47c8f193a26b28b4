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
  return nearestHit(scene, ray, { accepts: (hit) => isShown(scene, hit, transparent) });
}

/** Whether a surface is there for who looks at it from where the ray comes. */
export function isShown(scene: TracedScene, hit: Hit, transparent: Transparent): boolean {
  if (!hit.front && !scene.objects[hit.object].mesh.doubleSided) return false;
  const material = materialOf(scene, hit);
  if (transparent === 'skip' && scene.transparent.has(material)) return false;
  const { opacityThreshold } = material;
  return opacityThreshold === 0 || opacityAt(scene, hit) >= opacityThreshold;
}
