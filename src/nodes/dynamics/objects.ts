import { add, scale, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { boundingBox } from '../../scene/bounds/bounds.ts';
import { bakedMesh } from '../../scene/mesh/stretch.ts';
import { isStatic, poseAt } from '../../scene/motion/motion.ts';
import { applyPose } from '../../scene/motion/poses.ts';
import type { Pose, SceneObject } from '../../scene/types.ts';
import { nodeRefusal } from '../common/params.ts';

/** Objects thinner than this fraction of their size are flat. */
export const FLATNESS_TOLERANCE = 1e-3;

/** Pose of an object at the start of a simulation, at 0 s; c [m/s]. */
export const initialPose = ({ motion }: SceneObject, c: number): Pose => poseAt(motion, START_TIME, c);

/** [s] */
export const START_TIME = 0;

/** Trajectory of the point x of an object, in its own frame; c [m/s]. */
export const trajectoryOf =
  ({ motion }: SceneObject, x: Vec3, c: number) =>
  (t: number): Vec3 =>
    applyPose(poseAt(motion, t, c), x);

/** Center of its mesh's bounding box, in its own frame. */
export function meshCenter(object: SceneObject): Vec3 {
  const { min, max } = meshBounds(object);
  return scale(add(min, max), 0.5);
}

export const isMoving = ({ motion }: SceneObject): boolean => !isStatic(motion);

/** Bounds of its mesh, in its own frame. */
export function meshBounds(object: SceneObject) {
  const bounds = boundingBox(bakedMesh(object).positions);
  if (!bounds) throw nodeRefusal('matter.empty', object.path, msg`it has no points; leave it out`);
  return bounds;
}
