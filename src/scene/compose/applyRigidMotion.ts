import { multiply, rotate } from '../../math/quat.ts';
import { add, length } from '../../math/vec3.ts';
import { meshBoundingSphere } from '../bounds/bounds.ts';
import { applyPose, samplePose } from '../motion/motion.ts';
import type { Pose, RigidMotion, Scene, SceneObject } from '../types.ts';
import { withObjects } from './assignMaterial.ts';
import { matchesPath } from './mergeScenes.ts';

/** Things at a path and below it that move already: a motion of the whole would have to be added to their own. */
export const movingPaths = (scene: Scene, path: string): readonly string[] =>
  scene.objects.filter((o) => matchesPath(o.path, path) && o.motion.kind !== 'static').map((o) => o.path);

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
  const objects = withObjects(scene, path, (object) =>
    object.motion.kind === 'static'
      ? { ...object, authoredIn, motion: composeMotion(frame, object.motion.pose) }
      : object,
  );
  const lights = scene.lights.map((light) =>
    'motion' in light && light.motion.kind === 'static' && matchesPath(light.path, path)
      ? { ...light, motion: composeMotion(frame, light.motion.pose) }
      : light,
  );
  return { ...scene, objects, lights };
}

/** What stands at a pose in a frame that moves. */
export function composeMotion(frame: RigidMotion, pose: Pose): RigidMotion {
  if (frame.kind !== 'sampled') return { ...frame, pose: composePoses(frame.pose, pose) };
  const poses = new Float64Array(frame.poses.length);
  for (let k = 0; k < frame.times.length; k++) {
    const { position, orientation } = composePoses(samplePose(frame.poses, k), pose);
    poses.set([...position, ...orientation], 7 * k);
  }
  return { ...frame, poses };
}

const composePoses = (frame: Pose, { position, orientation }: Pose): Pose => ({
  position: add(frame.position, rotate(frame.orientation, position)),
  orientation: multiply(frame.orientation, orientation),
});

/** How far from the origin anything at a path and below it reaches [m]. */
export function reachFromOrigin(scene: Scene, path: string): number {
  return scene.objects
    .filter((object) => matchesPath(object.path, path))
    .reduce((most, { mesh, motion }) => {
      const { center, radius } = meshBoundingSphere(mesh);
      return Math.max(most, length(motion.kind === 'static' ? applyPose(motion.pose, center) : center) + radius);
    }, 0);
}
