import type { RectLight } from '../../../scene/types.ts';
import { areaSample, inOwnFrame, localLightTracer } from './localLight.ts';
import { sphericalRect } from './sphericalRect.ts';

export const RECT_LIGHT = localLightTracer<RectLight>(
  inOwnFrame((at, { width, height }, random) => {
    if (at[2] >= 0) return undefined;
    const [p, q] = [random(), random()];
    const across = [-width / 2 - at[0], width / 2 - at[0]] as const;
    const up = [-height / 2 - at[1], height / 2 - at[1]] as const;
    const { x, y, solidAngle } = sphericalRect(across, up, at[2], p, q);
    // Smaller solid angles, differences of angles, are lost to rounding.
    if (solidAngle > 1e-6) return { toward: [x, y, -at[2]], weight: solidAngle };
    return areaSample(at, [(p - 0.5) * width, (q - 0.5) * height, 0], width * height);
  }),
);
