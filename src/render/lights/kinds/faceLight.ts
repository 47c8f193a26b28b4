import { dot, length, min, select } from 'three/tsl';
import type { Float, Vec3 } from '../../../shaders/types.ts';
import type { AreaGeometry, PlacedArea } from './areaLight.ts';

/** What faces have in common: they shine to one side of their plane. */
export const FACE: Pick<AreaGeometry, 'isLit' | 'distanceAlong'> = {
  isLit: ({ center, front }) => dot(center, front).lessThan(0),
  distanceAlong: (n, { center, front }) => dot(center, front).div(dot(n, front).min(-1e-6)),
};

/** Where a unit ray comes to a face's plane, in its half axes from its middle. */
export function planeIntersection(ray: Vec3, { X, Y, center, front }: PlacedArea): readonly [x: Float, y: Float] {
  const [depth, slope] = [dot(center, front).toVar(), dot(ray, front).toVar()];
  // A ray that does not come to the plane is followed as far as the face's middle.
  const reach = select(slope.lessThan(-1e-4), min(depth.div(slope.min(-1e-4)), 1e6), length(center));
  const off = ray.mul(reach).sub(center).toVar();
  const x = dot(off, X).div(dot(X, X)).toVar();
  const y = dot(off, Y).div(dot(Y, Y)).toVar();
  return [x, y];
}

/** Cosine of the angle at which a face is seen. */
export const facing = ({ front }: PlacedArea, toCenter: Vec3): Float => dot(toCenter, front).negate();
