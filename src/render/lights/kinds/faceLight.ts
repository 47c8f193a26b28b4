import { dot, length, min, select } from 'three/tsl';
import type { Float, Vec3 } from '../../../shaders/types.ts';
import type { AreaGeometry, PlacedArea } from './areaLight.ts';

/** Shared by faces, which shine to one side of their plane. */
export const FACE: Pick<AreaGeometry, 'isLit' | 'distanceAlong'> = {
  isLit: ({ center, front }) => dot(center, front).lessThan(0),
  distanceAlong: (n, { center, front }) => dot(center, front).div(dot(n, front).min(-1e-6)),
};

/** Where a unit ray meets a face's plane, in half axes from its centre. */
export function planeIntersection(ray: Vec3, { X, Y, center, front }: PlacedArea): readonly [x: Float, y: Float] {
  const [depth, slope] = [dot(center, front).toVar(), dot(ray, front).toVar()];
  // A ray that does not meet the plane is followed as far as the face's centre.
  const reach = select(slope.lessThan(-1e-4), min(depth.div(slope.min(-1e-4)), 1e6), length(center));
  const offset = ray.mul(reach).sub(center).toVar();
  const x = dot(offset, X).div(dot(X, X)).toVar();
  const y = dot(offset, Y).div(dot(Y, Y)).toVar();
  return [x, y];
}

/** Cosine of the angle at which a face is seen. */
export const facing = ({ front }: PlacedArea, toCenter: Vec3): Float => dot(toCenter, front).negate();
