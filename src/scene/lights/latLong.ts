import { IDENTITY, rotate } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { DomeLight } from './light.ts';

// A latitude–longitude map as OpenEXR and UsdLux define it: in the dome's own axes its top row is +Y, its middle +Z, and a quarter of its width
// to the left of that is +X.

/** Map coordinates of a unit direction: u to the right, v up, both 0 … 1. */
export function latLongFromDirection([x, y, z]: Vec3): readonly [u: number, v: number] {
  return [0.5 - Math.atan2(x, z) / (2 * Math.PI), 1 - Math.acos(Math.min(Math.max(y, -1), 1)) / Math.PI];
}

/** The unit direction at (u, v). */
export function directionFromLatLong(u: number, v: number): Vec3 {
  const longitude = 2 * Math.PI * (0.5 - u);
  const down = Math.PI * (1 - v);
  const level = Math.sin(down);
  return [level * Math.sin(longitude), Math.cos(down), level * Math.cos(longitude)];
}

/** The dome's own axes in the world. */
export const domeAxes = ({ orientation = IDENTITY }: DomeLight): readonly [x: Vec3, y: Vec3, z: Vec3] => [
  rotate(orientation, [1, 0, 0]),
  rotate(orientation, [0, 1, 0]),
  rotate(orientation, [0, 0, 1]),
];
