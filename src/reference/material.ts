import type { Material } from '../scene/types.ts';
import type { TracedScene } from './trace.ts';
import type { Hit } from './types.ts';

/** The place in `Scene.materials` of what the triangle that is hit is made of. */
export function materialPlace({ objects }: TracedScene, { object, corner }: Hit): number {
  const group = objects[object].mesh.groups.find(({ start, count }) => corner >= start && corner < start + count);
  return group?.material ?? 0;
}

/** The material of the triangle that is hit. */
export const materialOf = (scene: TracedScene, hit: Hit): Material => scene.scene.materials[materialPlace(scene, hit)];
