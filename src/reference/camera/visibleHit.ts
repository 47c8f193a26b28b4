import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import { nearestHit, type TracedScene } from '../intersection/tracedScene.ts';
import { materialOf } from '../materials/material.ts';
import { opacityAt } from '../materials/surface.ts';

/** Blended surfaces count, or only those that hide what is behind them. */
export type TransparentMode = 'hit' | 'skip';

/**
 * What a picture shows on a ray: the nearest front side, or back side where the mesh is double sided, without what is cut out.
 * Data of a picture are of what hides the rest, so transparent surfaces are skipped there.
 */
export function visibleHit(
  scene: TracedScene,
  ray: SpacetimeRay,
  transparent: TransparentMode = 'skip',
): Hit | undefined {
  const accepts = (hit: Hit): boolean => isVisible(scene, hit, transparent);
  return nearestHit(scene, ray, { visibleSides: true, alwaysAccept: scene.opaqueObjects, accepts });
}

/** Whether any of the surface is left at a hit. */
function isVisible(scene: TracedScene, hit: Hit, transparent: TransparentMode): boolean {
  const material = materialOf(scene, hit);
  if (scene.transparentMaterials.has(material)) return transparent === 'hit';
  return material.opacityThreshold === 0 || opacityAt(scene, hit) >= material.opacityThreshold;
}
