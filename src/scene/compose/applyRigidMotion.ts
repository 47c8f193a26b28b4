import { length, ZERO } from '../../math/vec3.ts';
import { objectBoundingSphere } from '../bounds/bounds.ts';
import { isStatic, restingPose } from '../motion/motion.ts';
import { motionKind } from '../motion/motions.ts';
import { applyPose } from '../motion/poses.ts';
import type { Pose, RigidMotion, Scene, SceneCamera, SceneObject } from '../types.ts';
import { withObjects } from './assignMaterial.ts';
import { matchesPath } from './mergeScenes.ts';

/** Paths of those objects or cameras at a path and below it that already move, so that a common motion cannot be applied to them. */
export const movingPaths = (items: readonly (SceneObject | SceneCamera)[], path: string): readonly string[] =>
  items.filter((item) => matchesPath(item.path, path) && !isStatic(item.motion)).map((item) => item.path);

/**
 * Attaches the objects, lights and cameras at rest at a path and below it to a moving frame, in which each keeps its pose. `rest`: their meshes are rest shapes, each
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
  const cameras = scene.cameras.map((camera) => {
    const pose = matchesPath(camera.path, path) ? restingPose(camera.motion) : undefined;
    return pose ? { ...camera, motion: composeMotion(frame, pose) } : camera;
  });
  return { ...scene, objects, lights, cameras };
}

/** The motion of a body at a fixed pose in a moving frame. */
export const composeMotion = (frame: RigidMotion, pose: Pose): RigidMotion => motionKind(frame).compose(frame, pose);

/** Largest distance from the origin of anything at a path and below it [m]. */
export function reachFromOrigin(scene: Scene, path: string): number {
  const cameras = scene.cameras
    .filter((camera) => matchesPath(camera.path, path))
    .map(({ motion }) => length(restingPose(motion)?.position ?? ZERO));
  return scene.objects
    .filter((object) => matchesPath(object.path, path))
    .reduce(
      (max, object) => {
        const { center, radius } = objectBoundingSphere(object);
        const pose = restingPose(object.motion);
        return Math.max(max, length(pose ? applyPose(pose, center) : center) + radius);
      },
      Math.max(0, ...cameras),
    );
}
