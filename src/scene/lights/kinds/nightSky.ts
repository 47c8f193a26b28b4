import { multiply } from '../../../math/quat.ts';
import type { NightSky } from '../light.ts';
import type { LightKind } from './lightKind.ts';

export const NIGHT_SKY: LightKind<NightSky> = {
  reach: 'stars',
  transform: (light, by) => ({ ...light, orientation: multiply(by.orientation, light.orientation) }),
};
