import type { Material } from '../../scene/types.ts';
import type { Hit } from '../acceleration/ray.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';

/** Index in `Scene.materials` of the hit triangle's material. */
export function materialIndex({ objects }: TracedScene, { object, corner }: Hit): number {
  const group = objects[object].mesh.groups.find(({ start, count }) => corner >= start && corner < start + count);
  return group?.material ?? 0;
}

/** The material of the hit triangle. */
export const materialOf = (scene: TracedScene, hit: Hit): Material => scene.scene.materials[materialIndex(scene, hit)];
