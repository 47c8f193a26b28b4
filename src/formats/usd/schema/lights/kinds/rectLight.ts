import type { RectLight } from '../../../../../scene/types.ts';
import { localLightSchema } from './localLight.ts';

export const RECT_LIGHT = localLightSchema<RectLight>('RectLight', {
  isOneSided: true,
  isTextured: true,
  shape: (size, [sx, sy]) => ({ kind: 'rect', width: size('width', 1) * sx, height: size('height', 1) * sy }),
  radiance: (shape, { over }) => ({ shape, gain: over(shape.width * shape.height) }),
});
