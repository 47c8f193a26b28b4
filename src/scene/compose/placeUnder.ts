import type { Scene } from '../types.ts';

/** The same scene with all its prims below a path, materials too. */
export function placeUnder(scene: Scene, path: string): Scene {
  const below = <T extends { readonly path: string }>(item: T): T => ({ ...item, path: `${path}${item.path}` });
  return {
    ...scene,
    objects: scene.objects.map(below),
    cameras: scene.cameras.map(below),
    lights: scene.lights.map(below),
    materials: scene.materials.map((material) => {
      const { name } = material;
      return { ...material, name: name.startsWith('/') ? `${path}${name}` : `${path}/Materials/${name || 'Material'}` };
    }),
  };
}
