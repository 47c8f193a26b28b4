import type { StaticMotion } from '../../../scene/types.ts';
import type { LightMotionKind } from './lightMotionKind.ts';

export const STATIC_MOTION: LightMotionKind<StaticMotion> = {
  sampleTexels: () => 0,
  write: () => ({ motion: [0, 0, 0, 1], w: 1, used: 0 }),
  emission: undefined,
};
