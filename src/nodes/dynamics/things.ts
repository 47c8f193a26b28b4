import { boundingBox } from '../../scene/bounds.ts';
import type { Pose, SceneObject } from '../../scene/types.ts';
import { refusal } from '../geometry/shared.ts';

/** What is flat is thinner than this share of its size. */
export const FLAT = 1e-3;

/** A thing at rest has one pose. */
export const poseOf = ({ motion }: SceneObject): Pose => {
  if (motion.kind !== 'static') throw new TypeError('only things at rest come here');
  return motion.pose;
};

/** Of its mesh, in its own frame. */
export function boundsOf({ mesh, path }: SceneObject) {
  const bounds = boundingBox(mesh.positions);
  if (!bounds) throw refusal('matter.empty', path, 'it has no points; leave it out');
  return bounds;
}
