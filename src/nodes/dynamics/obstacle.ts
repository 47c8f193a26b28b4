import { box, type Obstacle, plane } from '../../dynamics/forces/obstacle.ts';
import { conjugate, multiply, rotate, rotationAngle } from '../../math/quat.ts';
import { addScaled, length, normalize, sub, type Vec3 } from '../../math/vec3.ts';
import { placed, samplePose } from '../../scene/motion.ts';
import { pointAt } from '../../scene/polygons.ts';
import type { SceneObject } from '../../scene/types.ts';
import { refusal } from '../geometry/shared.ts';
import type { SolidMatter } from './matter.ts';
import { boundsOf, FLAT, middleOf, poseOf } from './things.ts';

/** What a thing is for what would get into it, as it lies when the simulation begins; c [m/s]. */
export function obstacleOf(object: SceneObject, part: SolidMatter, c: number): Obstacle {
  const { min, max } = boundsOf(object);
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

/** Places of a moving obstacle that tell how it lies, in its thing's own frame: its middle, and where it turns the ends of arms along its x and y. */
export function carriersOf(object: SceneObject, { orientation }: Obstacle, c: number): Vec3[] {
  const middle = middleOf(object);
  if (!turns(object)) return [middle];
  const { min, max } = boundsOf(object);
  // As far out as it is large: what would go faster than light there is told.
  const reach = Math.max(...sub(max, min)) / 2;
  const own = multiply(conjugate(poseOf(object, c).orientation), orientation);
  return [middle, addScaled(middle, rotate(own, [1, 0, 0]), reach), addScaled(middle, rotate(own, [0, 1, 0]), reach)];
}

function turns({ motion }: SceneObject): boolean {
  if (motion.kind !== 'sampled') return false;
  const first = conjugate(samplePose(motion.poses, 0).orientation);
  return motion.times.some(
    (_, k) => rotationAngle(multiply(first, samplePose(motion.poses, k).orientation)) >= LEAST_TURN,
  );
}

/** [rad] */
const LEAST_TURN = 1e-6;
