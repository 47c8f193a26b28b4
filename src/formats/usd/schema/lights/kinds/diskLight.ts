import type { DiskLight } from '../../../../../scene/types.ts';
import { localLightSchema } from './localLight.ts';

export const DISK_LIGHT = localLightSchema<DiskLight>('DiskLight', {
  isOneSided: true,
  shape: (size, [sx, sy]) => ({ kind: 'disk', radius: size('radius', 0.5) * Math.sqrt(sx * sy) }),
  radiance: (shape, { over }) => ({ shape, gain: over(Math.PI * shape.radius ** 2) }),
});
