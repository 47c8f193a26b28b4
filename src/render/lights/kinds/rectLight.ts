import { clamp, length } from 'three/tsl';
import type { RectLight } from '../../../scene/types.ts';
import { type AreaGeometry, addAreaLight } from './areaLight.ts';
import { FACE, facing, planeIntersection } from './faceLight.ts';
import { type FacePolygon, faceOutline } from './lightOutline.ts';
import type { LightShader } from './lightShader.ts';

const CORNERS: FacePolygon = { count: 4, first: Math.PI / 4, reach: Math.SQRT2 };

const GEOMETRY: AreaGeometry = {
  ...FACE,
  outline: ({ center, X, Y }) => faceOutline(CORNERS, center, X, Y),
  nearestPoint(ray, light) {
    const [x, y] = planeIntersection(ray, light);
    const { center, X, Y } = light;
    return center.add(X.mul(clamp(x, -1, 1))).add(Y.mul(clamp(y, -1, 1)));
  },
  projectedArea: (light, toCenter) => length(light.X).mul(length(light.Y)).mul(4).mul(facing(light, toCenter)),
  aspectRatio: ({ X, Y }) => length(X).div(length(Y)),
};

export const RECT_LIGHT: LightShader<RectLight> = {
  maxUnrolled: 1,
  needsAxes: true,
  extents: ({ width, height }) => ({ x: width / 2, y: height / 2, radius: 0, gain: 1 }),
  bulbRadius: () => 0,
  addReflected: (...of) => addAreaLight(GEOMETRY, ...of),
  silhouette: ({ shape }) => [shape!.X, shape!.Y],
  isParallelogram: true,
};
