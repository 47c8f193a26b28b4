import { float, sqrt } from 'three/tsl';
import type { DiskLight } from '../../../scene/types.ts';
import { type AreaGeometry, addAreaLight } from './areaLight.ts';
import { FACE, facing, planeIntersection } from './faceLight.ts';
import { type FacePolygon, faceOutline } from './lightOutline.ts';
import type { LightShader } from './lightShader.ts';

const STEP = (2 * Math.PI) / 16;
/** A polygon with the area of the circle. */
const CORNERS: FacePolygon = { count: 16, first: 0, reach: Math.sqrt(STEP / Math.sin(STEP)) };

const GEOMETRY: AreaGeometry = {
  ...FACE,
  outline: ({ center, X, Y }) => faceOutline(CORNERS, center, X, Y),
  nearestPoint(ray, light) {
    const [x, y] = planeIntersection(ray, light);
    const { center, X, Y } = light;
    const inside = sqrt(x.mul(x).add(y.mul(y))).max(1);
    return center.add(X.mul(x.div(inside))).add(Y.mul(y.div(inside)));
  },
  projectedArea: (light, toCenter) => light.radius.mul(light.radius).mul(Math.PI).mul(facing(light, toCenter)),
  aspectRatio: () => float(1),
};

export const DISK_LIGHT: LightShader<DiskLight> = {
  maxUnrolled: 1,
  needsAxes: true,
  extents: ({ radius }) => ({ x: radius, y: radius, radius, gain: 1 }),
  bulbRadius: () => 0,
  addReflected: (...of) => addAreaLight(GEOMETRY, ...of),
  silhouette: ({ shape }) => [shape!.X, shape!.Y],
  isParallelogram: false,
};
