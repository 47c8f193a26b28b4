import { length } from '../../math/vec3.ts';
import { objectBoundingSphere } from '../bounds/bounds.ts';
import { isStatic, restingPose } from '../motion/motion.ts';
import { motionKind } from '../motion/motions.ts';
import { applyPose } from '../motion/poses.ts';
import type { Pose, RigidMotion, Scene, SceneObject } from '../types.ts';
import { withObjects } from './assignMaterial.ts';
import { matchesPath } from './mergeScenes.ts';

/** Paths of the objects at a path and below it that already move, so that a common motion cannot be applied to them. */
export const movingPaths = (scene: Scene, path: string): readonly string[] =>
  scene.objects.filter((o) => matchesPath(o.path, path) && !isStatic(o.motion)).map((o) => o.path);

/**
 * Attaches the objects and lights at rest at a path and below it to a moving frame, in which each keeps its pose. `rest`: their meshes are rest shapes, each
 * contracted towards its own origin.
 */
export function applyRigidMotion(
  scene: Scene,
  path: string,
  frame: RigidMotion,
  authoredIn: SceneObject['authoredIn'],
): Scene {
  const objects = withObjects(scene, path, (object) => {
    const pose = restingPose(object.motion);
    return pose ? { ...object, authoredIn, motion: composeMotion(frame, pose) } : object;
  });
  const lights = scene.lights.map((light) => {
    const pose = 'motion' in light && matchesPath(light.path, path) ? restingPose(light.motion) : undefined;
    return pose ? { ...light, motion: composeMotion(frame, pose) } : light;
  });
  return { ...scene, objects, lights };
}

/** The motion of a body at a fixed pose in a moving frame. */
export const composeMotion = (frame: RigidMotion, pose: Pose): RigidMotion => motionKind(frame).compose(frame, pose);

/** Largest distance from the origin of anything at a path and below it [m]. */
export function reachFromOrigin(scene: Scene, path: string): number {
  return scene.objects
    .filter((object) => matchesPath(object.path, path))
    .reduce((max, object) => {
      const { center, radius } = objectBoundingSphere(object);
      const pose = restingPose(object.motion);
      return Math.max(max, length(pose ? applyPose(pose, center) : center) + radius);
    }, 0);
}
