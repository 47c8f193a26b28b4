import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import { nearestHit, type TracedScene } from '../intersection/tracedScene.ts';
import { materialOf } from '../materials/material.ts';
import { opacityAt } from '../materials/surface.ts';

/** Whether alpha-blended surfaces are hit or skipped. */
export type TransparentMode = 'hit' | 'skip';

/**
 * The hit that a picture shows: the nearest front side, or back side of double-sided meshes, except cut-outs. By default transparent
 * surfaces are skipped, as in data channels.
 * @example
 * import { makeObject, makeScene, plane, restingAt } from 'slowlight/scene';
 * const wall = makeObject({ path: '/Wall', mesh: plane(2, 2), motion: restingAt([0, 0, -4]) });
 * const scene = createTracedScene(makeScene({ name: 'wall', objects: [wall] }), 10);
 * const hit = visibleHit(scene, { t: 0, x: [0, 0, 0], dt: -1, dx: [0, 0, -1] });
 * hit; // { s: 4, object: 0, position: [0, 0, -4], time: -0.4 }
 */
export function visibleHit(
  scene: TracedScene,
  ray: SpacetimeRay,
  transparent: TransparentMode = 'skip',
): Hit | undefined {
  const accepts = (hit: Hit): boolean => isVisible(scene, hit, transparent);
  return nearestHit(scene, ray, { visibleSides: true, alwaysAccept: scene.opaqueObjects, accepts });
}

/** Whether the surface is visible at a hit. */
function isVisible(scene: TracedScene, hit: Hit, transparent: TransparentMode): boolean {
  const material = materialOf(scene, hit);
  if (scene.transparentMaterials.has(material)) return transparent === 'hit';
  return material.opacityThreshold === 0 || opacityAt(scene, hit) >= material.opacityThreshold;
}
