import { length } from '../../math/vec3.ts';
import { meshBoundingSphere } from '../bounds/bounds.ts';
import { isStatic, restingPose } from '../motion/motion.ts';
import { motionKind } from '../motion/motions.ts';
import { applyPose } from '../motion/poses.ts';
import type { Pose, RigidMotion, Scene, SceneObject } from '../types.ts';
import { withObjects } from './assignMaterial.ts';
import { matchesPath } from './mergeScenes.ts';

/** Things at a path and below it that move already: a motion of the whole would have to be added to their own. */
export const movingPaths = (scene: Scene, path: string): readonly string[] =>
  scene.objects.filter((o) => matchesPath(o.path, path) && !isStatic(o.motion)).map((o) => o.path);

/**
 * Things at rest, at a path and below it, lamps too, carried as one body by the motion of a frame: each keeps its place in that frame.
 * `rest`: their meshes are shapes at rest, each contracted towards its own origin.
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

/** What stands at a pose in a frame that moves. */
export const composeMotion = (frame: RigidMotion, pose: Pose): RigidMotion => motionKind(frame).compose(frame, pose);

/** How far from the origin anything at a path and below it reaches [m]. */
export function reachFromOrigin(scene: Scene, path: string): number {
  return scene.objects
    .filter((object) => matchesPath(object.path, path))
    .reduce((most, { mesh, motion }) => {
      const { center, radius } = meshBoundingSphere(mesh);
      const pose = restingPose(motion);
      return Math.max(most, length(pose ? applyPose(pose, center) : center) + radius);
    }, 0);
}
