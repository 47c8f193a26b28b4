import { add, scale, type Vec3 } from '../../math/vec3.ts';
import { boundingBox } from '../../scene/bounds.ts';
import { placed, poseAt } from '../../scene/motion.ts';
import type { Pose, SceneObject } from '../../scene/types.ts';
import { refusal } from '../geometry/shared.ts';

/** What is flat is thinner than this share of its size. */
export const FLAT = 1e-3;

/** How a thing lies when a simulation begins, which is at 0 s; c [m/s]. */
export const poseOf = ({ motion }: SceneObject, c: number): Pose => poseAt(motion, BEGIN, c);

/** [s] */
export const BEGIN = 0;

/** The way of a place of a thing, x in its own frame; c [m/s]. */
export const wayOf =
  ({ motion }: SceneObject, x: Vec3, c: number) =>
  (t: number): Vec3 =>
    placed(poseAt(motion, t, c), x);

/** Of its mesh's box, in its own frame. */
export function middleOf(object: SceneObject): Vec3 {
  const { min, max } = boundsOf(object);
  return scale(add(min, max), 0.5);
}

export const isMoving = ({ motion }: SceneObject): boolean => motion.kind !== 'static';

/** Of its mesh, in its own frame. */
export function boundsOf({ mesh, path }: SceneObject) {
  const bounds = boundingBox(mesh.positions);
  if (!bounds) throw refusal('matter.empty', path, 'it has no points; leave it out');
  return bounds;
}
