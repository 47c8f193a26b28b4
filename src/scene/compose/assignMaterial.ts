import { withMaterial } from '../mesh/meshOps.ts';
import type { Lifetime, Material, Scene, SceneObject } from '../types.ts';
import { matchesPath } from './mergeScenes.ts';

/** Assigns one material to all objects at a path and below it. */
export function assignMaterial(scene: Scene, path: string, material: Material): Scene {
  const index = scene.materials.length;
  const objects = withObjects(scene, path, (object) => ({ ...object, mesh: withMaterial(object.mesh, index) }));
  return { ...scene, objects, materials: [...scene.materials, material] };
}

/** Sets the lifetime of the objects and lights at a path and below it. */
export const withLifetime = (scene: Scene, path: string, lifetime: Lifetime): Scene => ({
  ...scene,
  objects: withObjects(scene, path, (object) => ({ ...object, lifetime })),
  lights: scene.lights.map((light) =>
    'lifetime' in light && matchesPath(light.path, path) ? { ...light, lifetime } : light,
  ),
});

/** The objects of a scene, with `change` applied to those at a path and below it. */
export const withObjects = (
  { objects }: Scene,
  path: string,
  change: (object: SceneObject) => SceneObject,
): readonly SceneObject[] => objects.map((object) => (matchesPath(object.path, path) ? change(object) : object));
