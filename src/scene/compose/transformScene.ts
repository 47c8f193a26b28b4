import { IDENTITY, scaledUniformly } from '../../math/mat4.ts';
import { lightKind } from '../lights/lightKinds.ts';
import { transformMesh } from '../mesh/meshOps.ts';
import { transformedQuadric, withoutQuadric } from '../mesh/quadric.ts';
import { linearOf, type SimilarityTransform } from '../motion/kinds/changes.ts';
import { deforms } from '../motion/motion.ts';
import { motionKind } from '../motion/motions.ts';
import type { Light, Mesh, Motion, Scene, SceneObject } from '../types.ts';

/**
 * Transforms a whole scene: objects, lights, cameras and the directions of its sky.
 *
 * Speeds are multiplied by the scale, because times do not change. Of hyperbolic motion the proper acceleration is scaled: it never reaches c, so at high speed
 * its path only approximates the scaled one.
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
  const { mesh, motion, stretch } = object;
  return {
    ...object,
    ...(stretch ? { stretch: stretch.map((x) => by.scale * x) } : { mesh: transformedMesh(mesh, motion, by) }),
    motion: motionKind(motion).transform(motion, by),
  };
}

/** Scales a mesh. Deforming meshes are world-oriented and therefore also rotated. */
function transformedMesh(mesh: Mesh, motion: Motion, { orientation, scale: s }: SimilarityTransform): Mesh {
  if (deforms(motion)) return transformMesh(mesh, linearOf(orientation, s));
  if (s === 1) return mesh;
  const quadric = transformedQuadric(mesh.quadric, scaledUniformly(IDENTITY, s));
  return { ...withoutQuadric(mesh), positions: mesh.positions.map((x) => s * x), ...quadric };
}

/** Radiance does not change with the scale, so that a scaled room is lit as before; the `color` of point and line lights, an intensity, does. */
function transformLight(light: Light, by: SimilarityTransform): Light {
  const transformed = lightKind(light).transform(light, by);
  return 'motion' in transformed
    ? { ...transformed, motion: motionKind(transformed.motion).transform(transformed.motion, by) }
    : transformed;
}
