import { box, type Obstacle, plane } from '../../dynamics/forces/obstacle.ts';
import { conjugate, multiply, rotate, rotationAngle } from '../../math/quat.ts';
import { addScaled, length, normalize, sub, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { bakedMesh } from '../../scene/mesh/stretch.ts';
import { poseSamples } from '../../scene/motion/motion.ts';
import { applyPose, samplePose } from '../../scene/motion/poses.ts';
import type { SceneObject } from '../../scene/types.ts';
import { nodeRefusal } from '../common/params.ts';
import type { ColliderMatter } from './matter.ts';
import { FLATNESS_TOLERANCE, initialPose, meshBounds, meshCenter } from './objects.ts';

/** The obstacle of an object in its initial pose; c [m/s]. */
export function obstacleOf(object: SceneObject, part: ColliderMatter, c: number): Obstacle {
  const { min, max } = meshBounds(object);
  const pose = initialPose(object, c);
  const middle = meshCenter(object);
  if (part.shape === 'box') return box(applyPose(pose, middle), sub(max, min), pose.orientation);
  const { normals, positions } = bakedMesh(object);
  const sum = [0, 1, 2].map((k) => normals.reduce((all, x, i) => (i % 3 === k ? all + x : all), 0));
  const front = normalize(sum as unknown as Vec3);
  const depths = Array.from({ length: positions.length / 3 }, (_, i) => {
    const d = sub(pointAt(positions, i), middle);
    return Math.abs(d[0] * front[0] + d[1] * front[1] + d[2] * front[2]);
  });
  const thick = depths.reduce((most, depth) => Math.max(most, depth), 0);
  if (length(front) > 0 && thick <= FLATNESS_TOLERANCE * length(sub(max, min))) {
    return plane(applyPose(pose, middle), rotate(pose.orientation, front));
  }
  const message = msg`it is not flat, so that it is no plane; choose the shape box or ball`;
  throw nodeRefusal('collider.plane', object.path, message, { node: part.node, param: 'shape', value: 'box' });
}

/**
 * Points that carry a moving obstacle and determine its pose, in its object's frame: its center, and if it rotates the
 * ends of arms along its x and y axes.
 */
export function carrierPositions(object: SceneObject, { orientation }: Obstacle, c: number): Vec3[] {
  const middle = meshCenter(object);
  if (!isRotating(object)) return [middle];
  const { min, max } = meshBounds(object);
  // The arms extend to the obstacle's size, so that rotation faster than light is detected.
  const reach = Math.max(...sub(max, min)) / 2;
  const own = multiply(conjugate(initialPose(object, c).orientation), orientation);
  return [middle, addScaled(middle, rotate(own, [1, 0, 0]), reach), addScaled(middle, rotate(own, [0, 1, 0]), reach)];
}

function isRotating({ motion }: SceneObject): boolean {
  const samples = poseSamples(motion);
  if (!samples) return false;
  const first = conjugate(samplePose(samples.poses, 0).orientation);
  return samples.times.some(
    (_, k) => rotationAngle(multiply(first, samplePose(samples.poses, k).orientation)) >= MIN_ROTATION,
  );
}

/** [rad] */
const MIN_ROTATION = 1e-6;
