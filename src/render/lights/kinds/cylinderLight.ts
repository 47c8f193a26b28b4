import { acos, clamp, cos, cross, dot, float, int, length, max, min, normalize, select, sin, sqrt } from 'three/tsl';
import type { CylinderLight } from '../../../scene/types.ts';
import type { Vec3 } from '../../../shaders/types.ts';
import { type AreaGeometry, addAreaLight, type PlacedArea } from './areaLight.ts';
import type { LightOutline } from './lightOutline.ts';
import type { LightShader } from './lightShader.ts';

/** Radius over length of the tube that stands for a line (radius 0). */
const LINE_RADIUS_RATIO = 5e-4;

const GEOMETRY: AreaGeometry = {
  isLit: ({ center }) => dot(center, center).greaterThan(0),
  outline: tubeOutline,
  // That of its centre.
  distanceAlong: (_, { center }) => length(center),
  nearestPoint,
  projectedArea({ X, radius }, toCenter) {
    const along = dot(toCenter, normalize(X));
    return length(X)
      .mul(radius)
      .mul(4)
      .mul(sqrt(max(along.mul(along).oneMinus(), 0)));
  },
  aspectRatio({ X, radius }, toCenter) {
    const along = dot(toCenter, normalize(X));
    return length(X)
      .div(radius)
      .mul(sqrt(max(along.mul(along).oneMinus(), 1e-6)));
  },
};

export const CYLINDER_LIGHT: LightShader<CylinderLight> = {
  maxUnrolled: 1,
  needsAxes: true,
  extents(light) {
    const radius = light.radius || LINE_RADIUS_RATIO * light.length;
    return { x: light.length / 2, y: 1, radius, gain: light.radius > 0 ? 1 : 1 / (2 * radius) };
  },
  bulbRadius: ({ radius }) => radius,
  addReflected: (...of) => addAreaLight(GEOMETRY, ...of),
  silhouette({ radius, shape, offset }) {
    const to = normalize(offset).toVar();
    const { X } = shape!;
    return [X, normalize(cross(X, to)).mul(radius)];
  },
  isParallelogram: true,
};

/** Corners at each end of a tube's outline. */
const END_CORNERS = 7;

/**
 * Outline of the side of a tube with the half axis X: its two silhouette lines, joined by half a circle at each end.
 * Empty from its inside.
 */
function tubeOutline({ center, X, radius }: PlacedArea): LightOutline {
  const axis = normalize(X).toVar();
  const across = center.sub(axis.mul(dot(center, axis))).toVar();
  const away = length(across).max(1e-9).toVar();
  const e = across.div(away).negate().toVar();
  const s = cross(axis, e).toVar();
  const open = acos(min(radius.div(away), 1)).toVar();
  return {
    count: 2 * END_CORNERS,
    corner: (k) => {
      const far = k.greaterThanEqual(int(END_CORNERS));
      const step = float(select(far, int(2 * END_CORNERS - 1).sub(k), k)).div((END_CORNERS - 1) / 2);
      const phi = open.mul(step.sub(1)).toVar();
      const rim = e
        .mul(cos(phi))
        .add(s.mul(sin(phi)))
        .mul(radius);
      return center.add(X.mul(select(far, float(-1), float(1)))).add(rim);
    },
  };
}

function nearestPoint(ray: Vec3, { X, radius, center }: PlacedArea): Vec3 {
  const slope = dot(ray, X).toVar();
  const spread = dot(X, X).sub(slope.mul(slope)).max(1e-9);
  const s = clamp(slope.mul(dot(ray, center)).sub(dot(center, X)).div(spread), -1, 1);
  const axis = center.add(X.mul(s)).toVar();
  const offset = ray.mul(dot(ray, axis).max(0)).sub(axis).toVar();
  return axis.add(offset.mul(min(radius.div(length(offset).max(1e-9)), 1)));
}
