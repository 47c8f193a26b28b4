import { box, type Obstacle, plane } from '../../dynamics/forces/obstacle.ts';
import { rotate } from '../../math/quat.ts';
import { add, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { placed } from '../../scene/motion.ts';
import { pointAt } from '../../scene/polygons.ts';
import type { SceneObject } from '../../scene/types.ts';
import { refusal } from '../geometry/shared.ts';
import type { SolidMatter } from './matter.ts';
import { boundsOf, FLAT, poseOf } from './things.ts';

/** What a thing at rest is for what would get into it. */
export function obstacleOf(object: SceneObject, part: SolidMatter): Obstacle {
  const { min, max } = boundsOf(object);
  const pose = poseOf(object);
  const middle = scale(add(min, max), 0.5);
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
