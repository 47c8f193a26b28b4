import type { CylinderLight } from '../../../../../scene/types.ts';
import { localLightSchema } from './localLight.ts';

export const CYLINDER_LIGHT = localLightSchema<CylinderLight>('CylinderLight', {
  isOneSided: false,
  shape: (size, [sx, sy, sz]) => ({
    kind: 'cylinder',
    radius: size('radius', 0.5) * Math.sqrt(sy * sz),
    length: size('length', 1) * sx,
  }),
  /** With `treatAsLine` or without a radius it is a line, with the same irradiance at a distance. */
  radiance(shape, { isNormalized, over, isFlagged }) {
    const { radius, length } = shape;
    if (radius > 0 && !isFlagged('treatAsLine')) return { shape, gain: over(2 * Math.PI * radius * length) };
    const gain = isNormalized ? over(Math.PI * length) : radius > 0 ? 2 * radius : 1;
    return { shape: { ...shape, radius: 0 }, gain };
  },
});
