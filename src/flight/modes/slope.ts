import { addScaled, dot, normalize, type Vec3 } from '../../math/vec3.ts';

/** The level part of a vector. */
export const withoutUp = (v: Vec3, up: Vec3): Vec3 => addScaled(v, up, -dot(v, up));

/** The unit vector above or below a level one in a plane with a normal that is not level: where one goes who keeps to the plane. */
export const onSlope = (level: Vec3, normal: Vec3, up: Vec3): Vec3 =>
  normalize(addScaled(level, up, -dot(normal, level) / dot(normal, up)));
