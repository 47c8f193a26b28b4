import type { Material } from '../../scene/types.ts';
import type { Hit } from '../acceleration/ray.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';

/** Index in `Scene.materials` of the hit triangle's material. */
export function materialIndex({ objects }: TracedScene, { object, corner }: Hit): number {
  const group = objects[object].mesh.groups.find(({ start, count }) => corner >= start && corner < start + count);
  return group?.material ?? 0;
}

/**
 * The material of the hit triangle.
 * @example
 * import { makeMaterial, makeObject, makeScene, sphere } from 'slowlight/scene';
 * const objects = [makeObject({ path: '/Ball', mesh: sphere(1) })];
 * const scene = createTracedScene(makeScene({ name: 'ball', objects, materials: [makeMaterial({ name: 'gold' })] }), 10);
 * const hit = visibleHit(scene, { t: 0, x: [0, 0, 5], dt: -1, dx: [0, 0, -1] })!;
 * materialOf(scene, hit).name; // 'gold'
 */
export const materialOf = (scene: TracedScene, hit: Hit): Material => scene.scene.materials[materialIndex(scene, hit)];
