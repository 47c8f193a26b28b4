import { box, type Obstacle, plane } from '../../dynamics/forces/obstacle.ts';
import { conjugate, multiply, rotate, rotationAngle } from '../../math/quat.ts';
import { length, normalize, sub, type Vec3 } from '../../math/vec3.ts';
import { placed, samplePose } from '../../scene/motion.ts';
import { pointAt } from '../../scene/polygons.ts';
import type { SceneObject } from '../../scene/types.ts';
import { refusal } from '../geometry/shared.ts';
import type { SolidMatter } from './matter.ts';
import { boundsOf, FLAT, middleOf, poseOf } from './things.ts';

/** What a thing is for what would get into it, as it lies when the simulation begins; c [m/s]. */
export function obstacleOf(object: SceneObject, part: SolidMatter, c: number): Obstacle {
  const { min, max } = boundsOf(object);
  refuseTurning(object, part);
  const pose = poseOf(object, c);
  const middle = middleOf(object);
  if (part.shape === 'box') return box(placed(pose, middle), sub(max, min), pose.orientation);
  const { normals, positions } = object.mesh;
  const sum = [0, 1, 2].map((k) => normals.reduce((all, x, i) => (i % 3 === k ? all + x : all), 0));
  const front = normalize(sum as unknown as Vec3);
  const depths = Array.from({ length: positions.length / 3 }, (_, i) => {
    const d = sub(pointAt(positions, i), middle);
    return Math.abs(d[0] * front[0] + d[1] * front[1] + d[2] * front[2]);
  });
  const thick = depths.reduce((most, depth) => Math.max(most, depth), 0);
  if (length(front) > 0 && thick <= FLAT * length(sub(max, min))) {
    return plane(placed(pose, middle), rotate(pose.orientation, front));
  }
  const message = 'it is not flat, so that it is no plane; choose the shape box or ball';
  throw refusal('collider.plane', object.path, message, { node: part.node, param: 'shape', value: 'box' });
}

/** Planes and boxes go as they lie. */
function refuseTurning({ motion, path }: SceneObject, { node, shape }: SolidMatter): void {
  if (motion.kind !== 'sampled') return;
  const first = samplePose(motion.poses, 0).orientation;
  const turns = Array.from(motion.times, (_, k) =>
    rotationAngle(multiply(conjugate(first), samplePose(motion.poses, k).orientation)),
  );
  if (Math.max(...turns) < LEAST_TURN) return;
  const message = `it turns, and what collides with a ${shape} is computed for such as do not; choose the shape ball, or let it go without turning`;
  throw refusal('collider.turns', path, message, { node, param: 'shape', value: 'ball' });
}

/** [rad] */
const LEAST_TURN = 1e-6;
