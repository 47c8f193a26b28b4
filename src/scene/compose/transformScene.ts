import { lightKind } from '../lights/lightKinds.ts';
import { transformMesh } from '../mesh/meshOps.ts';
import { linearOf, type SimilarityTransform } from '../motion/kinds/changes.ts';
import { deforms } from '../motion/motion.ts';
import { motionKind } from '../motion/motions.ts';
import type { Light, Mesh, Motion, Scene, SceneObject } from '../types.ts';

/**
 * A scene as a whole at another place: what is in it, its lights, its cameras and the directions of its sky.
 *
 * Speeds grow with the scale, for every path is as much longer and takes as long. Of hyperbolic motion the proper acceleration does:
 * it never reaches c, so that its path is only nearly the enlarged one where it is fast.
 */
export const transformScene = (scene: Scene, by: SimilarityTransform): Scene => ({
  ...scene,
  objects: scene.objects.map((object) => transformObject(object, by)),
  lights: scene.lights.map((light) => transformLight(light, by)),
  cameras: scene.cameras.map((camera) => ({
    ...camera,
    motion: motionKind(camera.motion).transform(camera.motion, by),
  })),
});

export function transformObject(object: SceneObject, by: SimilarityTransform): SceneObject {
  const { motion } = object;
  return {
    ...object,
    mesh: enlargedMesh(object.mesh, motion, by),
    motion: motionKind(motion).transform(motion, by),
  };
}

/** A deforming mesh is world-oriented: it turns with its samples. */
function enlargedMesh(mesh: Mesh, motion: Motion, { orientation, scale: s }: SimilarityTransform): Mesh {
  if (deforms(motion)) return transformMesh(mesh, linearOf(orientation, s));
  return s === 1 ? mesh : { ...mesh, positions: mesh.positions.map((x) => s * x) };
}

/** Radiance does not change with the scale, so that a light of a scaled room lights it as before; of a point or line `color` is all of its light. */
function transformLight(light: Light, by: SimilarityTransform): Light {
  const turned = lightKind(light).transform(light, by);
  return 'motion' in turned ? { ...turned, motion: motionKind(turned.motion).transform(turned.motion, by) } : turned;
}
