import { withMaterial } from '../mesh/meshOps.ts';
import type { Lifetime, Material, Scene, SceneObject } from '../types.ts';
import { matchesPath } from './mergeScenes.ts';

/** Everything at a path and below it in one material, whatever it wore. */
export function assignMaterial(scene: Scene, path: string, material: Material): Scene {
  const place = scene.materials.length;
  const objects = withObjects(scene, path, (object) => ({ ...object, mesh: withMaterial(object.mesh, place) }));
  return { ...scene, objects, materials: [...scene.materials, material] };
}

/** Things at a path and below it, lamps too, are there only between two world times. */
export const withLifetime = (scene: Scene, path: string, lifetime: Lifetime): Scene => ({
  ...scene,
  objects: withObjects(scene, path, (object) => ({ ...object, lifetime })),
  lights: scene.lights.map((light) =>
    'lifetime' in light && matchesPath(light.path, path) ? { ...light, lifetime } : light,
  ),
});

/** The objects of a scene, those at a path and below it changed. */
export const withObjects = (
  { objects }: Scene,
  path: string,
  change: (object: SceneObject) => SceneObject,
): readonly SceneObject[] => objects.map((object) => (matchesPath(object.path, path) ? change(object) : object));
