import type { SphereLight } from '../../../../../scene/types.ts';
import { localLightSchema } from './localLight.ts';

export const SPHERE_LIGHT = localLightSchema<SphereLight>('SphereLight', {
  isOneSided: false,
  shape: (size, [sx, sy, sz]) => ({ kind: 'sphere', radius: size('radius', 0.5) * Math.cbrt(sx * sy * sz) }),
  /** With `treatAsPoint` or without a radius it is a point, with the same irradiance at a distance. */
  radiance(shape, { unit, isNormalized, over, isFlagged }) {
    const { radius } = shape;
    if (radius > 0 && !isFlagged('treatAsPoint')) return { shape, gain: over(4 * Math.PI * radius ** 2) };
    const gain = isNormalized ? unit ** 2 / 4 : radius > 0 ? Math.PI * radius ** 2 : 1;
    return { shape: { ...shape, radius: 0 }, gain };
  },
});
