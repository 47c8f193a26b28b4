import { withMaterial } from '../mesh/meshOps.ts';
import { commonLifetime } from '../motion/lifetimes.ts';
import type { Lifetime, Material, Scene, SceneObject } from '../types.ts';
import { matchesPath } from './mergeScenes.ts';

/** Assigns one material to all objects at a path and below it. */
export function assignMaterial(scene: Scene, path: string, material: Material): Scene {
  const index = scene.materials.length;
  const objects = withObjects(scene, path, (object) => ({ ...object, mesh: withMaterial(object.mesh, index) }));
  return { ...scene, objects, materials: [...scene.materials, material] };
}

/**
 * Limits the objects and lights at a path and below it to a lifetime: they exist where they did before and in that. Pieces that are left without time are
 * removed, unless nothing of their whole would remain.
 */
export const withLifetime = (scene: Scene, path: string, lifetime: Lifetime): Scene => ({
  ...scene,
  objects: limited(scene.objects, path, lifetime),
  lights: limited(scene.lights, path, lifetime),
});

function limited<T extends LimitedLife>(items: readonly T[], path: string, lifetime: Lifetime): T[] {
  const isLimited = (item: T): item is T & Required<Pick<LimitedLife, 'lifetime'>> =>
    item.lifetime !== undefined && matchesPath(item.path, path);
  const survivors = new Set(
    items.flatMap((item) => (!isLimited(item) || commonLifetime(item.lifetime, lifetime) ? [item.pieceOf] : [])),
  );
  return items.flatMap((item) => {
    if (!isLimited(item)) return [item];
    const { birth, death } = item.lifetime;
    const common = { birth: Math.max(birth, lifetime.birth), death: Math.min(death, lifetime.death) };
    const isGone = !(common.birth < common.death) && item.pieceOf !== undefined && survivors.has(item.pieceOf);
    return isGone ? [] : [{ ...item, lifetime: common }];
  });
}

interface LimitedLife {
  readonly path: string;
  readonly lifetime?: Lifetime;
  readonly pieceOf?: string;
}

/** The objects of a scene, with `change` applied to those at a path and below it. */
export const withObjects = (
  { objects }: Scene,
  path: string,
  change: (object: SceneObject) => SceneObject,
): readonly SceneObject[] => objects.map((object) => (matchesPath(object.path, path) ? change(object) : object));
